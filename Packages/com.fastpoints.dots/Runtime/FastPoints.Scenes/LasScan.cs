using System.Collections.Generic;
using FastPoints.Base;
using Unity.Jobs;

namespace FastPoints.Scenes
{
    /// <summary>The seeded scan as a LAS file: 36 bytes a point.</summary>
    public static class LasScan
    {
        /// <summary>Work for a pump. The file is there, whole, when the work has ended, and not at all when it was cancelled or
        /// failed.</summary>
        public static IEnumerator<JobHandle> Run(string path, long points, uint seed, ScanOrder order = ScanOrder.Strip,
            StageProgress progress = null)
        {
            using (var las = new LasReturnSink(path))
            {
                using (var work = OrderedScan.Run(points, seed, order, las, progress))
                    while (work.MoveNext())
                        yield return work.Current;
                las.Complete();
            }
        }
    }
}
