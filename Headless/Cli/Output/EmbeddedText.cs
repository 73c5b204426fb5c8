namespace FastPoints.Cli.Output;

/// <summary>Pages and scripts that are files of this project.</summary>
static class EmbeddedText
{
    /// <param name="values">What takes the place of {{Name}}.</param>
    public static string Of(string file, params ReadOnlySpan<(string Name, object Value)> values)
    {
        using var reader = new StreamReader(typeof(EmbeddedText).Assembly.GetManifestResourceStream(file)!);
        string text = reader.ReadToEnd().ReplaceLineEndings("\n");
        foreach (var (name, value) in values)
            text = text.Replace("{{" + name + "}}", string.Format(CultureInfo.InvariantCulture, "{0}", value));
        return text;
    }
}
