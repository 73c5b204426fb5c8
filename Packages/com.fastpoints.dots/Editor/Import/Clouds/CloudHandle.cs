using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Editor
{
    /// <summary>The content of a <c>.pointcloud</c> file, a small asset that stands for a cloud of any size: where the converted
    /// cloud and its source are, and what is known of them without opening either. It converts from and to text, without
    /// I/O.</summary>
    internal sealed class CloudHandle
    {
        public const string Extension = ".pointcloud";
        const int Version = 1;
        public const int MaxWarnings = 20;
        const string FormatName = "fastpoints-handle";
        public ulong CloudId; // The converted cloud's own id, which follows from its content; 0 until there is one.
        public string CloudPath; // The converted folder, as ProjectPaths.Stored writes it. It may not exist yet.

        /// <summary>Files and folders that the cloud is made of, written alike; empty for a cloud that was imported in converted
        /// form.</summary>
        public List<string> Sources = new List<string>();
        public bool IsSourceFolder; // Whether the source is a folder, which a missing one does not show.
        public bool IsSourceOctree; // Whether they contain an octree (COPC, Potree, EPT) and can be streamed directly.

        /// <summary>The position that transforms move, georeferenced: where the cloud was first shown. Null until then.</summary>
        public double3? Origin;
        public UpAxis OriginUp = UpAxis.Z; // The axis whose floor Origin lies on.
        public SourceStamp Stamp; // Stamp of the sources when they were taken; null without any.

        /// <summary>What was wrong with the sources when they were converted, one line each; at most
        /// <see cref="MaxWarnings"/>.</summary>
        public List<string> Warnings = new List<string>();

        public string Format;
        public long Points = -1; // What the header claims, until the cloud is converted; -1 if unknown.
        public BoundsGeo BoundsGeo = BoundsGeo.Empty; // What the header claims, as with Points; may be empty.

        public string Crs;

        public CloudUnits Units;

        public void SetFrom(SourceInfo info)
        {
            // These are the same at each import, whatever a conversion finds.
            if (!info.BoundsIfFinite.IsEmpty)
                Origin = UnityLocalSpace.Of(info.BoundsIfFinite, info.Crs.Units).OriginGeo;
            Format = info.Format;
            Points = info.PointsReadable >= 0 ? info.PointsReadable
                : info.HasPointsClaimed && info.PointsClaimed <= long.MaxValue ? (long)info.PointsClaimed : -1;
            BoundsGeo = info.BoundsIfFinite;
            Crs = info.Crs.Summary;
            Units = info.Crs.Units;
        }

        public void SetFrom(string format, IReadOnlyList<CloudWarning> warnings)
        {
            Format = format;
            Warnings.Clear();
            for (int i = 0; i < warnings.Count && i < MaxWarnings; i++)
                // Leaves out the folder, which differs on the next machine.
                Warnings.Add(i == MaxWarnings - 1 && warnings.Count > MaxWarnings ? warnings.Count - i + " more"
                    : new CloudWarning(Path.GetFileName(warnings[i].Path), warnings[i].ByteOffset, warnings[i].Text).ToString());
        }

        public void SetFrom(CloudManifest manifest)
        {
            CloudId = manifest.CloudId;
            Points = manifest.Points;
            BoundsGeo = manifest.BoundsGeo;
            Crs = manifest.CrsName;
            Units = manifest.Crs.Units;
        }

        public string ToJson()
        {
            var json = new JsonWriter().BeginObject().Add("format", FormatName).Add("version", Version).AddHex("cloudId", CloudId)
                .Add("cloud", CloudPath).BeginArray("sources");
            foreach (string source in Sources)
                json.Add(null, source);
            json.EndArray();
            if (IsSourceFolder)
                json.Add("folder", true);
            if (IsSourceOctree)
                json.Add("octree", true);
            if (Origin is double3 origin)
                json.Add("origin", origin.x, origin.y, origin.z);
            if (OriginUp != UpAxis.Z)
                json.Add("originUp", OriginUp.ToString());
            Stamp?.Write(json, "stamp", false);
            if (Warnings.Count > 0)
            {
                json.BeginArray("warnings");
                foreach (string warning in Warnings)
                    json.Add(null, warning);
                json.EndArray();
            }
            json.Add("sourceFormat", Format).Add("points", Points);
            if (!BoundsGeo.IsEmpty)
            {
                json.BeginObject("bounds").Add("min", BoundsGeo.Min.x, BoundsGeo.Min.y, BoundsGeo.Min.z)
                    .Add("max", BoundsGeo.Max.x, BoundsGeo.Max.y, BoundsGeo.Max.z).EndObject();
            }
            json.Add("crs", Crs).Add("metresPerUnit", Units.Horizontal);
            if (Units.Vertical != 0)
                json.Add("verticalMetresPerUnit", Units.Vertical);
            return json.EndObject().ToString();
        }

        /// <param name="path">For messages.</param>
        /// <exception cref="PointCloudException">The text is not a handle, has another version, or a member is missing or
        /// invalid.</exception>
        public static CloudHandle FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            if (json.Text("format") != FormatName)
                throw json.Failure("format", "wanted \"" + FormatName + "\", got \"" + json.Text("format") + "\"");
            json.RequireVersion(Version);
            var bounds = json.ObjectOrNull("bounds");
            var stamp = json.ObjectOrNull("stamp");
            var handle = new CloudHandle
            {
                CloudId = json.Hex("cloudId"),
                CloudPath = json.Text("cloud"),
                Sources = json.Texts("sources"),
                IsSourceFolder = json.Flag("folder"),
                IsSourceOctree = json.Flag("octree"),
                Origin = json.Has("origin") ? json.Vector("origin") : (double3?)null,
                OriginUp = AxisOf(json, "originUp"),
                Stamp = stamp == null ? null : SourceStamp.Read(stamp),
                Warnings = json.Has("warnings") ? json.Texts("warnings") : new List<string>(),
                Format = json.TextOrNull("sourceFormat"),
                Points = json.Long("points"),
                BoundsGeo = bounds == null ? BoundsGeo.Empty : new BoundsGeo(bounds.Vector("min"), bounds.Vector("max")),
                Crs = json.TextOrNull("crs"),
                Units = new CloudUnits(json.NumberOrNaN("metresPerUnit"), json.Has("verticalMetresPerUnit")
                    ? json.NumberOrNaN("verticalMetresPerUnit") : 0),
            };
            if (handle.CloudPath.Length == 0)
                throw json.Failure("cloud", "wanted a folder, got nothing");
            return handle;
        }

        static UpAxis AxisOf(JsonMembers json, string name)
        {
            string text = json.TextOrNull(name);
            if (text == null)
                return UpAxis.Z;
            return Enum.TryParse(text, out UpAxis axis) && Enum.IsDefined(typeof(UpAxis), axis) ? axis
                : throw json.Failure(name, "wanted X, Y, Z or one of these behind Negative, got \"" + text + "\"");
        }
    }
}
