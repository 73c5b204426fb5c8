using System.Collections.Generic;

namespace FastPoints.Store
{
    /// <summary>One file that a cloud was made from.</summary>
    internal struct CloudSource
    {
        // Without its folder.
        public string Name;
        public long FileBytes;
        public long Points;

        // See SourceInfo.
        public ulong HeadHash;

        // The file's own coordinate system, where files of several make one cloud; null if it is the cloud's.
        public CloudCrs Crs;
    }

    // The contents of sources.json: a country has a million of them, and whoever shows it needs none.
    internal static class StoredSources
    {
        // Sources with more coordinate systems than this share the last one.
        public const int MaxSystems = 64;

        // A million sources take about 100 MB.
        const int MaxTextBytes = 512 << 20;

        public static string ToJson(List<CloudSource> sources)
        {
            var json = new JsonWriter().BeginObject().Add("version", StoreFormat.Version);
            var systems = new List<CloudCrs>();
            var ofSource = sources.ConvertAll(source =>
            {
                int index = systems.FindIndex(s => s == source.Crs || s != null && s.IsSameEntryAs(source.Crs));
                if (index < 0 && systems.Count <= MaxSystems)
                    systems.Add(source.Crs);
                return index < 0 ? systems.Count - 1 : index;
            });
            if (systems.Count > 1)
            {
                json.BeginArray("systems");
                foreach (var system in systems)
                    CloudManifest.Write(json.BeginObject(), system ?? new CloudCrs());
                json.EndArray();
            }
            json.BeginArray("sources");
            for (int i = 0; i < sources.Count; i++)
            {
                json.BeginObject().Add("name", sources[i].Name).Add("bytes", sources[i].FileBytes)
                    .Add("points", sources[i].Points);
                if (sources[i].HeadHash != 0)
                    json.AddHex("head", sources[i].HeadHash);
                if (systems.Count > 1)
                    json.Add("system", ofSource[i]);
                json.EndObject();
            }
            return json.EndArray().EndObject().ToString();
        }

        /// <exception cref="PointCloudException">The file is damaged.</exception>
        public static List<CloudSource> Read(string folder)
        {
            string path = SourcePath.Combine(folder, StoreFormat.SourcesName);
            return StoreFile.TryReadText(path, out string text, MaxTextBytes) ? FromJson(text, path) : new List<CloudSource>();
        }

        public static List<CloudSource> FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            json.RequireVersion(StoreFormat.Version);
            var systems = json.Has("systems") ? json.Objects("systems").ConvertAll(CloudManifest.ReadCrs) : null;
            return json.Objects("sources").ConvertAll(source => new CloudSource
            {
                Name = source.Text("name"),
                FileBytes = source.Count("bytes"),
                Points = source.Count("points"),
                HeadHash = source.Has("head") ? source.Hex("head") : 0,
                Crs = systems?[(int)source.Count("system", systems.Count - 1)],
            });
        }
    }
}
