using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>A <see cref="TerrestrialScan"/> in any order. All orders except <see cref="ScanOrder.Strip"/> keep the whole scan
    /// in memory.</summary>
    internal static class OrderedScan
    {
        /// <summary>The limit for orders other than as acquired, which keep 44 bytes for each point.</summary>
        public const int MaxPoints = 32_000_000;

        const int ReturnsAtOnce = 65_536;

        /// <summary>Runs the scan as a coroutine.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There are more than <see cref="MaxPoints"/> in an order other than as
        /// acquired.</exception>
        public static IEnumerator<JobStep> Run(long points, uint seed, ScanOrder order, IReturnSink sink, StageProgress progress)
        {
            if (order == ScanOrder.Strip)
                return TerrestrialScan.Run(points, seed, sink.Append, progress);
            if (points > MaxPoints)
                throw new ArgumentOutOfRangeException(nameof(points), points, "does not fit in memory to be ordered");
            return RunInMemory((int)points, seed, order, sink, progress);
        }

        static IEnumerator<JobStep> RunInMemory(int points, uint seed, ScanOrder order, IReturnSink sink, StageProgress progress)
        {
            var returns = new NativeArray<ScanReturn>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            var returnNumber = new NativeArray<int>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            JobHandle ordering = default;
            try
            {
                int end = 0;
                void Keep(NativeArray<ScanReturn> batch)
                {
                    NativeArray<ScanReturn>.Copy(batch, 0, returns, end, batch.Length);
                    end += batch.Length;
                }
                yield return JobStep.Of(TerrestrialScan.Run(points, seed, Keep, progress));

                ordering = new OrderReturnsJob { Returns = returns, Order = order, Seed = seed, ReturnOfIndex = returnNumber }
                    .Schedule();
                yield return ordering;
                ordering.Complete();
                for (int first = 0; first < points; first += ReturnsAtOnce)
                {
                    sink.Append(returns, returnNumber.GetSubArray(first, Math.Min(ReturnsAtOnce, points - first)));
                    yield return default;
                }
            }
            finally
            {
                ordering.Complete();
                returns.Dispose();
                returnNumber.Dispose();
            }
        }
    }

    /// <summary>Receives the returns of a scan. It is called on the main thread; its arguments are valid only during the
    /// call.</summary>
    internal interface IReturnSink
    {
        void Append(NativeArray<ScanReturn> returns);

        /// <param name="returns">All returns.</param>
        /// <param name="returnNumber">Indices of the returns that come next, in this order.</param>
        void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnNumber);
    }

    [BurstCompile]
    internal struct OrderReturnsJob : IJob
    {
        const int TileGrid = 50_000, TilesPerRow = 10, Keys = 256;

        [ReadOnly] public NativeArray<ScanReturn> Returns;
        public ScanOrder Order;
        public uint Seed;
        [WriteOnly] public NativeArray<int> ReturnOfIndex; // Index of the return that comes at each place.

        public unsafe void Execute()
        {
            if (Order == ScanOrder.Random)
            {
                for (int i = 0; i < Returns.Length; i++)
                    ReturnOfIndex[i] = (int)Shuffled((uint)i, (uint)Returns.Length);
                return;
            }
            int* next = stackalloc int[Keys + 1];
            for (int i = 0; i <= Keys; i++)
                next[i] = 0;
            for (int i = 0; i < Returns.Length; i++)
                next[Key(Returns[i]) + 1]++;
            for (int i = 1; i <= Keys; i++)
                next[i] += next[i - 1];
            for (int i = 0; i < Returns.Length; i++)
                ReturnOfIndex[next[Key(Returns[i])]++] = i;
        }

        int Key(in ScanReturn r)
        {
            if (Order == ScanOrder.Class)
                return r.Classification;
            // The scene reaches 230 m from its middle: five tiles of 50 m each way.
            int2 tile = math.clamp(((new int2(r.X, r.Y) + TilesPerRow / 2 * TileGrid) / TileGrid), 0, TilesPerRow - 1);
            return tile.y * TilesPerRow + tile.x;
        }

        /// <summary>A permutation of 0 to count - 1: a Feistel network of four rounds over the next even number of bits, walked
        /// until it falls within the count.</summary>
        uint Shuffled(uint index, uint count)
        {
            int halfBits = math.max(1, (33 - math.lzcnt(count)) / 2);
            uint mask = (1u << halfBits) - 1;
            do
            {
                uint left = index >> halfBits, right = index & mask;
                for (uint round = 0; round < 4; round++)
                {
                    uint mixed = left ^ (SceneHash.Of(right, round, Seed) & mask);
                    left = right;
                    right = mixed;
                }
                index = left << halfBits | right;
            }
            while (index >= count);
            return index;
        }
    }

    /// <summary>The order of a generated cloud's points in its file.</summary>
    public enum ScanOrder
    {
        /// <summary>As acquired: station after station, scan line after scan line.</summary>
        Strip,
        /// <summary>By tiles of 50 m, row by row; as acquired within a tile.</summary>
        Tile,
        /// <summary>By class; as acquired within a class.</summary>
        Class,
        /// <summary>Shuffled: no two neighbours in the file are neighbours in space.</summary>
        Random,
    }
}
