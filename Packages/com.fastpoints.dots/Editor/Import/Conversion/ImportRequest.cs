using System;
using System.Collections.Generic;
using FastPoints.Nodes;

namespace FastPoints.Editor
{
    /// <summary>A cloud to convert. Paths are stored in the form of <see cref="ProjectPaths.Stored"/>.</summary>
    internal sealed class ImportRequest
    {
        public string AssetGuid; // The asset that the cloud is for, identified independently of its path.

        public List<string> Sources = new List<string>();

        public string Cloud;

        public Sampler Sampler;

        public bool AddsNormals;

        public bool OnlyNormalsLeft { get; internal set; }

        public ImportState State { get; internal set; }

        public string Failure { get; internal set; }

        public int Attempts { get; internal set; } // How often it was begun without ending properly.

        internal void Write(JsonWriter json)
        {
            json.BeginObject().Add("asset", AssetGuid).Add("cloud", Cloud).BeginArray("sources");
            foreach (string source in Sources)
                json.Add(null, source);
            json.EndArray().Add("sampler", Sampler.ToString()).Add("normals", AddsNormals).Add("isBuilt", OnlyNormalsLeft)
                .Add("state", State.ToString()).Add("attempts", Attempts).Add("failure", Failure).EndObject();
        }

        internal static ImportRequest Read(JsonMembers json) => new ImportRequest
        {
            AssetGuid = json.Text("asset"),
            Cloud = json.Text("cloud"),
            Sources = json.Texts("sources"),
            Sampler = Named<Sampler>(json, "sampler"),
            AddsNormals = json.Flag("normals"),
            OnlyNormalsLeft = json.Flag("isBuilt"),
            State = Named<ImportState>(json, "state"),
            Attempts = (int)Math.Min(int.MaxValue, Math.Max(0, json.Long("attempts"))),
            Failure = json.TextOrNull("failure"),
        };

        static T Named<T>(JsonMembers json, string name) where T : struct =>
            Enum.TryParse(json.Text(name), false, out T value) && value.ToString() == json.Text(name)
                ? value
                : throw json.Failure(name, "no such one: \"" + json.Text(name) + "\"");
    }

    /// <summary>The state of an <see cref="ImportRequest"/>. An imported one is no longer in the queue.</summary>
    internal enum ImportState
    {
        Waiting,
        Running,
        Paused,
        Failed,
    }
}
