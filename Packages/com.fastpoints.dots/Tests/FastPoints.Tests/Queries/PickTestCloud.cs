using System;
using FastPoints.Queries;
using FastPoints.Streaming;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    sealed class PickTestCloud : IDisposable
    {
        public const double Scale = 0.001;
        public static readonly double3 OriginGeo = new double3(690_000, 5_330_000, 500);

        readonly StreamedTestCloud m_cloud;

        public PickTestCloud(int points = 60_000, uint seed = 5)
        {
            var random = new Unity.Mathematics.Random(seed);
            Positions = new int3[points];
            Times = new double[points];
            Classes = new byte[points];
            Angles = new short[points];
            Extras = new float[points];
            var columns = new Array[] { new int[points], new int[points], new int[points], Classes, Times, Angles, Extras,
                new ushort[points], new ushort[points], new ushort[points] };
            for (int i = 0; i < points; i++)
            {
                // A ground with a wall, and a few points above it.
                var at = random.NextInt2(100_000);
                int height = (int)(4000 * math.sin(at.x * 1e-4) * math.cos(at.y * 2e-4)) + random.NextInt(30);
                if (i % 5 == 0)
                    (at.y, height) = (50_000 + random.NextInt(20), random.NextInt(20_000));
                else if (i % 997 == 0)
                    height += random.NextInt(30_000);
                Positions[i] = new int3(at, height);
                for (int axis = 0; axis < 3; axis++)
                    ((int[])columns[axis])[i] = Positions[i][axis];
                Times[i] = 300_000_000 + i * 1e-7;
                Classes[i] = (byte)random.NextInt(1, 8);
                Angles[i] = (short)random.NextInt(-30000, 30000);
                Extras[i] = random.NextFloat(-1, 1);
                for (int channel = 0; channel < 3; channel++)
                    ((ushort[])columns[7 + channel])[i] = (ushort)(random.NextInt(256) * 257);
            }
            Reds = (ushort[])columns[7];
            m_cloud = new StreamedTestCloud(4000, new MemoryReader(new PointSchema(new[]
            {
                new PointAttribute(AttributeNames.X, AttributeType.Int32),
                new PointAttribute(AttributeNames.Y, AttributeType.Int32),
                new PointAttribute(AttributeNames.Z, AttributeType.Int32),
                new PointAttribute(AttributeNames.Classification, AttributeType.UInt8),
                new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64),
                new PointAttribute(AttributeNames.ScanAngle, AttributeType.Int16, 0.006, 0),
                new PointAttribute("roughness", AttributeType.Float32),
                new PointAttribute(AttributeNames.Red, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Green, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Blue, AttributeType.UInt16),
            }), new PositionTransform { Scale = new double3(Scale, Scale, Scale), Offset = OriginGeo }, 5000, columns));
        }

        public int3[] Positions { get; }
        public byte[] Classes { get; }
        public double[] Times { get; }
        public short[] Angles { get; }
        public float[] Extras { get; }
        public ushort[] Reds { get; }
        public string Path => m_cloud.Path;
        public string[] ChunkFiles => m_cloud.ChunkFiles;

        public PointPicker Picker() => new PointPicker(FolderSource.OpenWhole(Path));

        public double3 Geo(int point) => new double3(Positions[point]) * Scale + OriginGeo;

        public static PickResult Find(PointPicker picker, PointQuery ray, CloudPlacement placement, PickOptions options = null)
        {
            var result = new PickResult();
            JobCoroutine.RunToEnd(picker.Find(ray, placement, options, result));
            return result;
        }

        /// <summary>The first hit by looking at every point; -1 if there is none.</summary>
        /// <param name="nextDistance">Of the second hit: if it is hardly farther, either may be found.</param>
        public int First(PointQuery ray, Func<double3, double3> toWorld, Func<int, bool> isShown, out double distance,
            out double nextDistance)
        {
            int first = -1;
            distance = nextDistance = double.PositiveInfinity;
            for (int i = 0; i < Positions.Length; i++)
            {
                if (isShown != null && !isShown(i))
                    continue;
                var from = toWorld(Geo(i)) - ray.OriginWorld;
                double along = math.dot(from, ray.DirectionWorld);
                double beside = math.length(math.cross(from, ray.DirectionWorld));
                if (along < ray.From || along > ray.To || beside > ray.RadiusAt(along))
                    continue;
                if (along < distance)
                    (first, nextDistance, distance) = (i, distance, along);
                else
                    nextDistance = Math.Min(nextDistance, along);
            }
            return first;
        }

        public static int3 StoredOf(PickedPoint point) => (int3)math.round((point.PositionGeo - OriginGeo) / Scale);

        public void Dispose() => m_cloud.Dispose();
    }
}
