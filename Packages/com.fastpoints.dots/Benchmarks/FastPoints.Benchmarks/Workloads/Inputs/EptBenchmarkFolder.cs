using System;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Export;
using FastPoints.Las;
using FastPoints.Scenes;
using FastPoints.Sources;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    static class EptBenchmarkFolder
    {
        const int NodePoints = 1 << 16;
        const double Scale = 0.01;

        static readonly (string Name, string Type, int Size)[] s_dimensions =
        {
            ("X", "signed", 4), ("Y", "signed", 4), ("Z", "signed", 4), ("Intensity", "unsigned", 2), ("Flags", "unsigned", 1),
            ("Classification", "unsigned", 1), ("ScanAngle", "signed", 1), ("UserData", "unsigned", 1),
            ("PointSourceId", "unsigned", 2), ("Red", "unsigned", 2), ("Green", "unsigned", 2), ("Blue", "unsigned", 2),
        };

        /// <param name="isLaz">LAZ nodes, otherwise plain records.</param>
        public static string Make(WorkloadContext context, bool isLaz)
        {
            string folder = Path.Combine(context.ScratchFolder,
                "ept-" + (isLaz ? "laz-" : "bin-") + context.Points + "-" + context.Seed);
            if (Directory.Exists(folder))
                return folder;
            string data = Path.Combine(folder, "ept-data"), hierarchy = Path.Combine(folder, "ept-hierarchy");
            Directory.CreateDirectory(data);
            Directory.CreateDirectory(hierarchy);
            string terrain = TerrainBenchmarkFile.Make(context);
            int nodes = (context.Points + NodePoints - 1) / NodePoints, level = 1;
            while (1 << 2 * level < nodes)
                level++;
            var page = new StringBuilder("{\"0-0-0-0\": 0");
            var records = new byte[NodePoints * TerrainBenchmarkFile.RecordBytes];
            using (var las = new FileStream(terrain, FileMode.Open, FileAccess.Read))
            {
                las.Position = LasHeader.BytesOf(2);
                for (int node = 0; node < nodes; node++)
                {
                    int count = Math.Min(NodePoints, context.Points - node * NodePoints);
                    int bytes = las.Read(records, 0, count * TerrainBenchmarkFile.RecordBytes);
                    if (bytes != count * TerrainBenchmarkFile.RecordBytes)
                        throw new IOException(terrain + " is shorter than its " + context.Points + " points");
                    string name = EptEntry.NameOf(level, new int3(node & (1 << level) - 1, node >> level, 0));
                    page.Append(", \"" + name + "\": " + count.ToString(CultureInfo.InvariantCulture));
                    string path = Path.Combine(data, name);
                    if (isLaz)
                        WriteLaz(path, records, count);
                    else
                        using (var file = File.Create(path + ".bin"))
                            file.Write(records, 0, bytes);
                }
            }
            File.WriteAllText(Path.Combine(hierarchy, "0-0-0-0.json"), page + "}");
            File.WriteAllText(Path.Combine(folder, "ept.json"), Index(context.Points, isLaz));
            return folder;
        }

        static void WriteLaz(string path, byte[] records, int count)
        {
            var settings = new LasWriterSettings { VersionMinor = 2, PointFormat = 2, Scale = new double3(Scale, Scale, Scale) };
            using (var writer = LasWriter.Create(path + ".las", settings))
            {
                writer.AppendRecords(records, count);
                writer.Complete();
            }
            using (var reader = PointReaders.Open(path + ".las"))
                JobCoroutine.RunToEnd(ExportCloud.Run(reader, path + ".laz", new ExportSettings(), _ => { }, null));
            File.Delete(path + ".las");
        }

        static string Index(int points, bool isLaz)
        {
            var text = new StringBuilder("{\"bounds\": [0, 0, -1000, 100000, 100000, 99000], \"dataType\": \""
                + (isLaz ? "laszip" : "binary") + "\", \"hierarchyType\": \"json\", \"points\": "
                + points.ToString(CultureInfo.InvariantCulture) + ", \"span\": 128, \"version\": \"1.0.0\", \"schema\": [");
            foreach (var (name, type, size) in s_dimensions)
                text.Append("{\"name\": \"" + name + "\", \"type\": \"" + type + "\", \"size\": " + size
                    + (name.Length == 1 ? ", \"scale\": 0.01, \"offset\": 0}," : "},"));
            text.Length--;
            return text.Append("]}").ToString();
        }
    }
}
