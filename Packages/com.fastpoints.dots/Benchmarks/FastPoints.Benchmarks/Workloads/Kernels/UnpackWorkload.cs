using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    public unsafe struct UnpackWorkload : IWorkload
    {
        const int Blocks = 8192;
        const int PerBlock = PlaneShape.MaxPointsPerBlock;

        static readonly int[] s_widths = { 9, 10, 7, 11, 8, 12, 6, 10, 9 };

        NativeArray<uint> m_plane, m_values;

        public string Name => "block unpack";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            var shape = new PlaneShape(3, 0);
            m_plane = new NativeArray<uint>((int)(shape.MaxBytes(Blocks, (long)Blocks * PerBlock) / 4), Allocator.Persistent);
            m_values = new NativeArray<uint>(3 * PerBlock, Allocator.Persistent);
            var plane = (uint*)m_plane.GetUnsafePtr();
            var values = (uint*)m_values.GetUnsafePtr();
            var random = new Unity.Mathematics.Random(context.Seed);
            long word = (long)Blocks * shape.DescriptorWords;
            for (int b = 0; b < Blocks; b++)
            {
                uint* descriptor = plane + b * shape.DescriptorWords;
                descriptor[0] = (uint)word;
                descriptor[1] = (uint)(PerBlock - 1) << 24;
                for (int c = 0; c < 3; c++)
                {
                    int width = s_widths[(b + c) % s_widths.Length];
                    descriptor[1] |= (uint)width << (8 * c);
                    descriptor[shape.MinimumWord(c)] = random.NextUInt(1 << 20);
                    for (int i = 0; i < PerBlock; i++)
                        values[i] = random.NextUInt(1u << width);
                    word += BlockCodec.Pack(values, 0, PerBlock, width, plane + word);
                }
            }
            Run();
        }

        public WorkloadResult Run()
        {
            var view = new PlaneView(m_plane.GetUnsafeReadOnlyPtr(), new PlaneShape(3, 0), Blocks);
            var values = (uint*)m_values.GetUnsafePtr();
            for (int b = 0; b < Blocks; b++)
                for (int c = 0; c < 3; c++)
                    view.Unpack(b, c, values + c * PerBlock);
            return new WorkloadResult { Points = (long)Blocks * PerBlock, Bytes = (long)Blocks * PerBlock * 12 };
        }

        public void Dispose()
        {
            m_plane.Dispose();
            m_values.Dispose();
        }
    }
}
