using System;
using System.Collections.Generic;
using FastPoints.Base;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Scenes
{
    /// <summary>A <see cref="TerrestrialScan"/> in any order. All orders except <see cref="ScanOrder.Strip"/> keep the whole scan
    /// in memory.</summary>
    internal static class OrderedScan
    {
        /// <summary>The limit for orders other than as acquired, which keep 44 bytes for each point.</summary>
        public const int MostPoints = 32_000_000;

        const int PlacesAtOnce = 65_536;

        /// <summary>Runs the scan as work for a pump.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There are more than <see cref="MostPoints"/> in an order other than as
        /// acquired.</exception>
        public static IEnumerator<Work> Run(long points, uint seed, ScanOrder order, IReturnSink sink, StageProgress progress)
        {
            if (order == ScanOrder.Strip)
                return TerrestrialScan.Run(points, seed, sink.Append, progress);
            if (points > MostPoints)
                throw new ArgumentOutOfRangeException(nameof(points), points, "does not fit in memory to be ordered");
            return RunInMemory((int)points, seed, order, sink, progress);
        }

        static IEnumerator<Work> RunInMemory(int points, uint seed, ScanOrder order, IReturnSink sink, StageProgress progress)
        {
            var returns = new NativeArray<ScanReturn>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            var returnOfPlace = new NativeArray<int>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            JobHandle ordering = default;
            try
            {
                int end = 0;
                void Keep(NativeArray<ScanReturn> batch)
                {
                    NativeArray<ScanReturn>.Copy(batch, 0, returns, end, batch.Length);
                    end += batch.Length;
                }
                yield return Work.Of(TerrestrialScan.Run(points, seed, Keep, progress));

                ordering = new OrderReturnsJob { Returns = returns, Order = order, Seed = seed, ReturnOfPlace = returnOfPlace }
                    .Schedule();
                yield return ordering;
                ordering.Complete();
                for (int first = 0; first < points; first += PlacesAtOnce)
                {
                    sink.Append(returns, returnOfPlace.GetSubArray(first, Math.Min(PlacesAtOnce, points - first)));
                    yield return default;
                }
            }
            finally
            {
                ordering.Complete();
                returns.Dispose();
                returnOfPlace.Dispose();
            }
        }
    }

    /// <summary>Receives the returns of a scan. It is called on the main thread; its arguments are valid only during the
    /// call.</summary>
    internal interface IReturnSink
    {
        void Append(NativeArray<ScanReturn> returns);

        /// <param name="returns">All returns.</param>
        /// <param name="returnOfPlace">Indices of the returns that come next, in this order.</param>
        void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnOfPlace);
    }
}
