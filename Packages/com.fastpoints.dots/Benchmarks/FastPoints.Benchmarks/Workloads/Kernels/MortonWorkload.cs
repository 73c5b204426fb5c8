using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>Morton codes of seeded coordinates, encoded and decoded again.</summary>
    public struct MortonWorkload : IWorkload
    {
        NativeArray<uint> m_coordinates;
        NativeArray<ulong> m_codes;
        NativeReference<ulong> m_differences;

        public string Name => "morton";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_coordinates = new NativeArray<uint>(3 * context.Points, Allocator.Persistent);
            m_codes = new NativeArray<ulong>(context.Points, Allocator.Persistent);
            m_differences = new NativeReference<ulong>(Allocator.Persistent);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int i = 0; i < m_coordinates.Length; i++)
                m_coordinates[i] = random.NextUInt() & Morton.MaxCoordinate;
        }

        public WorkloadResult Run()
        {
            new MortonJob { Coordinates = m_coordinates, Codes = m_codes, Differences = m_differences }.Run();
            return new WorkloadResult { Points = m_codes.Length, Bytes = m_codes.Length * 20L, Error = m_differences.Value };
        }

        public void Dispose()
        {
            m_coordinates.Dispose();
            m_codes.Dispose();
            m_differences.Dispose();
        }

        [BurstCompile]
        struct MortonJob : IJob
        {
            [ReadOnly] public NativeArray<uint> Coordinates;
            public NativeArray<ulong> Codes;

            public NativeReference<ulong> Differences;

            public void Execute()
            {
                for (int i = 0; i < Codes.Length; i++)
                    Codes[i] = Morton.Encode(Coordinates[3 * i], Coordinates[3 * i + 1], Coordinates[3 * i + 2]);
                uint differences = 0;
                for (int i = 0; i < Codes.Length; i++)
                {
                    Morton.Decode(Codes[i], out uint x, out uint y, out uint z);
                    differences |= x ^ Coordinates[3 * i] | y ^ Coordinates[3 * i + 1] | z ^ Coordinates[3 * i + 2];
                }
                Differences.Value = differences;
            }
        }
    }
}
