using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>The facts of a source, in a file of the cloud that was converted from it alone.</summary>
    internal static class StoredFacts
    {
        const int MaxChars = 4 << 20;

        public static string ToJson(SourceInfo info)
        {
            var json = new JsonWriter().BeginObject().Add("tell", info.OnlyInFacts).BeginArray("facts");
            int room = MaxChars;
            foreach (var fact in info.Facts)
            {
                room -= fact.Key.Length + fact.Value.Length;
                if (room >= 0)
                    json.BeginObject().Add("name", fact.Key).Add("value", fact.Value).EndObject();
            }
            if (room < 0)
                info.Losses.Add(new Loss("facts", info.Path, "those beyond " + MaxChars + " characters are not kept"));
            return json.EndArray().EndObject().ToString();
        }

        public static void AddTo(SourceInfo info, CloudFolder folder)
        {
            string path = SourcePath.Combine(folder.FolderPath, StoreFormat.FactsName);
            if (!StoreFile.TryReadText(path, out string text))
                return;
            var json = JsonMembers.Parse(text, path);
            info.OnlyInFacts = json.TextOrNull("tell");
            foreach (var fact in json.Objects("facts"))
                info.Fact(fact.Text("name"), fact.Text("value"));
        }
    }
}
