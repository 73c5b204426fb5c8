namespace FastPoints.HostTests.Manual;

public sealed class ManualSettingsTests
{
    static readonly Type[] s_components = typeof(PointCloudSettings).Assembly.GetTypes()
        .Where(t => typeof(MonoBehaviour).IsAssignableFrom(t) && t.IsPublic).ToArray();

    static IEnumerable<string> Components() => s_components.Select(t => t.Name);

    [TestCaseSource(nameof(Components))]
    public void Table_OfAComponent_MatchesTheInspector(string name)
    {
        var type = s_components.Single(t => t.Name == name);
        string menu = type.GetCustomAttribute<AddComponentMenu>().componentMenu;
        var rows = ManualPage.Of("settings.md").TableUnder("### " + menu[(menu.LastIndexOf('/') + 1)..]);

        Assert.That(rows.Select(Written), Is.EqualTo(Fields(type).Select(f => Row(Nicified(f.Name), f, RangeOf(f)))));
    }

    [Test]
    public void Table_OfProjectSettings_MatchesThePage()
    {
        string source =
            File.ReadAllText(Path.Combine(Checkout.Repository.PackageRoot, "Editor/Import/Assets/FastPointsSettingsPage.cs"));
        var shown = Regex.Matches(source,
            @"(EditorGUILayout\.|CloudFields)\w*\(new GUIContent\(""(?<label>[^""]+)"",\s+(""[^""]+""[\s+]*)+\), " +
            @"settings\.(?<field>\w+)(, (?<low>\d+), (?<high>\d+))?\)")
            .Select(m => Row(m.Groups["label"].Value, typeof(FastPointsSettings).GetField(m.Groups["field"].Value),
                m.Groups["low"].Success ? m.Groups["low"].Value + " to " + m.Groups["high"].Value : null)).ToList();

        Assert.That(shown, Has.Count.EqualTo(Fields(typeof(FastPointsSettings)).Count()), "each field is on the page");
        Assert.That(ManualPage.Of("settings.md").TableUnder("## Project settings").Select(Written), Is.EqualTo(shown));
    }

    [TestCase("UploadMebibytesPerFrame", "Upload Mebibytes Per Frame")]
    [TestCase("m_hiddenClasses", "Hidden Classes")]
    [TestCase("MaxSizePx", "Max Size Px")]
    public void Nicified_Field_MatchesTheInspector(string field, string shown) =>
        Assert.That(Nicified(field), Is.EqualTo(shown));

    [Test]
    public void Row_OtherDefaultOrRange_IsAnotherRow()
    {
        var field = typeof(PointCloudSettings).GetField(nameof(PointCloudSettings.MillionPoints));

        Assert.That(Row("Million Points", field, RangeOf(field)), Is.EqualTo("Million Points, `MillionPoints`, 2, 0.1 to 100"));
    }

    static string Written(string[] cells) => string.Join(", ", cells.Take(4));

    static string Row(string label, FieldInfo field, string range) =>
        string.Join(", ", label, "`" + field.Name + "`", DefaultOf(field), range ?? ChoicesOf(field.FieldType));

    static IEnumerable<FieldInfo> Fields(Type type) =>
        type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)
            .Where(f => (f.IsPublic || f.GetCustomAttribute<SerializeField>() != null) &&
                f.GetCustomAttribute<HideInInspector>() == null);

    static string DefaultOf(FieldInfo field)
    {
        object value = field.GetValue(Activator.CreateInstance(field.DeclaringType, true));
        return value switch
        {
            null => "none",
            bool isOn => isOn ? "on" : "off",
            IList { Count: 0 } => "none",
            IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
            _ => value.ToString(),
        };
    }

    static string RangeOf(FieldInfo field)
    {
        if (field.GetCustomAttribute<UnityEngine.RangeAttribute>() is { } range)
            return string.Create(CultureInfo.InvariantCulture, $"{range.min} to {range.max}");
        return field.GetCustomAttribute<MinAttribute>() is { } min
            ? string.Create(CultureInfo.InvariantCulture, $"{min.min} or more") : null;
    }

    static string ChoicesOf(Type type) => type == typeof(bool) ? "on, off"
        : type.IsEnum ? string.Join(", ", Enum.GetNames(type)) : "any";

    /// <summary>As Unity's inspector names a field: without prefix, a blank before each capital that begins a word.</summary>
    static string Nicified(string field)
    {
        string name = field.StartsWith("m_", StringComparison.Ordinal) ? field[2..] : field;
        return Regex.Replace(char.ToUpperInvariant(name[0]) + name[1..], "(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ");
    }
}
