using System;
using System.IO;
using FastPoints.Scenes;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>The seeded LAS file that the LAS workloads share: point format 2, 26 bytes a point.</summary>
    static class LasBenchmarkFile
    {
        public const int PointFormat = 2;
        public const int RecordBytes = 26;
        public const int BlockPoints = 32768;
        public const int ColorByte = 20;

        static readonly string[] s_wanted =
        {
            AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue,
        };

        public static PointSchema Wanted(PointSchema schema) => schema.Select(s_wanted);

        public static string Make(WorkloadContext context)
        {
            string path = context.PathOf("las", ".las");
            if (File.Exists(path))
                return path;
            var settings = new LasWriterSettings
            {
                VersionMinor = 2,
                PointFormat = PointFormat,
                Offset = new double3(500000, 4500000, 0),
            };
            var records = new byte[BlockPoints * RecordBytes];
            var random = new System.Random((int)context.Seed);
            using var writer = LasWriter.Create(path, settings);
            for (int first = 0; first < context.Points; first += BlockPoints)
            {
                random.NextBytes(records);
                writer.AppendRecords(records, Math.Min(BlockPoints, context.Points - first));
            }
            writer.Complete();
            return path;
        }
    }
}
