using System;
using System.IO;
using FastPoints.Build;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>A seeded LAS file of a hilly surface with a few objects, in strips like an airborne scan: point format
    /// 2, millimetres, coloured.</summary>
    public static unsafe class TerrainBenchmarkFile
    {
        public const int RecordBytes = 26;
        const double Spacing = 8;
        const int PointsPerPiece = 16384;

        public static double SideMetres(WorkloadContext context) => Math.Sqrt(context.Points) * Spacing * 1e-3;

        public static string Make(WorkloadContext context)
        {
            string path = context.PathOf("terrain", ".las");
            if (File.Exists(path))
                return path;
            var settings = new LasWriterSettings { VersionMinor = 2, PointFormat = 2, Offset = new double3(500000, 4500000, 0) };
            var records = new byte[PointsPerPiece * RecordBytes];
            var random = new Unity.Mathematics.Random(context.Seed);
            double side = Math.Sqrt(context.Points) * Spacing;
            int perLine = Math.Max(1, (int)Math.Sqrt(context.Points));
            using var writer = LasWriter.Create(path, settings);
            for (int first = 0; first < context.Points; first += PointsPerPiece)
            {
                int count = Math.Min(PointsPerPiece, context.Points - first);
                fixed (byte* start = records)
                    for (int i = 0; i < count; i++)
                        Write(start + i * RecordBytes, first + i, perLine, side, ref random);
                writer.AppendRecords(records, count);
            }
            writer.Complete();
            return path;
        }

        public static string MakeConverted(WorkloadContext context)
        {
            string las = Make(context), path = Path.ChangeExtension(las, StoreFormat.FolderExtension);
            if (Directory.Exists(path))
                return path;
            var settings =
                new ConvertSettings { Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue } };
            using (var reader = PointReaders.Open(las))
                JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, path, settings, r => { }, null));
            return path;
        }

        static void Write(byte* record, int index, int perLine, double side, ref Unity.Mathematics.Random random)
        {
            double x = (index % perLine + random.NextDouble()) * Spacing, y = (index / perLine + random.NextDouble()) * Spacing;
            double height = 800 * math.sin(x / side * 9) * math.cos(y / side * 7) +
                60 * math.sin(x * 0.01) + random.NextDouble() * 3;
            if ((((int)(x / 900) * 73856093 ^ (int)(y / 900) * 19349663) & 7) == 0)
                height += 600;
            ((int*)record)[0] = (int)x;
            ((int*)record)[1] = (int)y;
            ((int*)record)[2] = (int)height;
            *(ushort*)(record + 12) = (ushort)random.NextInt(4096);
            uint shade = (uint)(110 + height / 10) + random.NextUInt(12);
            *(ushort*)(record + 20) = (ushort)(shade * 256);
            *(ushort*)(record + 22) = (ushort)((shade + random.NextUInt(6)) * 256);
            *(ushort*)(record + 24) = (ushort)((shade / 2 + random.NextUInt(6)) * 256);
        }
    }
}
