using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Samplers
{
    /// <summary>Ranges that wait for their spacing's turn: those of one spacing in their order along the curve, wherever they
    /// come from, each with the number of the next one.</summary>
    internal unsafe struct RangeQueue : IDisposable
    {
        NativeList<SampledRange> m_ranges;

        // For each cell size, the first and the last range, or -1.
        NativeArray<int> m_first;
        NativeArray<int> m_last;

        public RangeQueue(Allocator allocator)
        {
            m_ranges = new NativeList<SampledRange>(64, allocator);
            m_first = new NativeArray<int>(GridCube.MaxSideLog2 + 1, allocator);
            m_last = new NativeArray<int>(GridCube.MaxSideLog2 + 1, allocator);
        }

        public ref SampledRange this[int number] => ref m_ranges.ElementAt(number);

        public void Clear()
        {
            m_ranges.Clear();
            for (int i = 0; i < m_first.Length; i++)
                m_first[i] = m_last[i] = -1;
        }

        public void Add(in SampledRange range)
        {
            int number = m_ranges.Length, cell = range.CellLog2;
            m_ranges.Add(range);
            var ranges = m_ranges.GetUnsafePtr();
            int after = m_last[cell];
            if (after >= 0 && ranges[after].First > range.First)
            {
                int before = m_first[cell];
                after = -1;
                for (; ranges[before].First < range.First; before = ranges[before].Next)
                    after = before;
            }
            if (after >= 0)
            {
                ranges[number].Next = ranges[after].Next;
                ranges[after].Next = number;
            }
            else
            {
                ranges[number].Next = m_first[cell];
                m_first[cell] = number;
            }
            if (ranges[number].Next < 0)
                m_last[cell] = number;
        }

        /// <summary>Takes the ranges of the widest spacing out of the queue.</summary>
        /// <param name="cellLog2">log2 of the spacing.</param>
        /// <returns>The number of the first one, or -1 if none waits.</returns>
        public int TakeWidest(out int cellLog2)
        {
            for (cellLog2 = GridCube.MaxSideLog2; cellLog2 >= 0; cellLog2--)
            {
                int first = m_first[cellLog2];
                if (first < 0)
                    continue;
                m_first[cellLog2] = m_last[cellLog2] = -1;
                return first;
            }
            return -1;
        }

        public void Dispose()
        {
            m_ranges.Dispose();
            m_first.Dispose();
            m_last.Dispose();
        }
    }

    /// <summary>The points of one cube while a sampler works on them: a range of the ordered points. Blittable.</summary>
    internal struct SampledRange
    {
        public int First;
        public int End;

        /// <summary>The nearest node above, or -1.</summary>
        public int Parent;

        /// <summary>At first any cube with the points; then the smallest of the octree.</summary>
        public byte SideLog2;

        /// <summary>log2 of the edge of the sampling cells: the spacing.</summary>
        public byte CellLog2;

        /// <summary>Number of points that are taken into the node.</summary>
        public int Count;

        /// <summary>The next range of the same spacing, or -1.</summary>
        public int Next;
    }
}
