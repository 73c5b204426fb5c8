using System;
using System.IO;
using FastPoints.Scenes;

namespace FastPoints.Cli
{
    /// <summary>The seeded scan as a file.</summary>
    public static class DemoCloud
    {
        public const long DefaultPoints = 5_000_000;
        public const int MostOrderedPoints = OrderedScan.MostPoints;

        /// <param name="path">Ends in .las or .ply; anything else becomes LAS.</param>
        public static void Write(string path, long points, uint seed, ScanOrder order, CliRun run)
        {
            run.Progress.Begin("scan");
            if (Path.GetExtension(path).Equals(".ply", StringComparison.OrdinalIgnoreCase))
            {
                using var file = new OutputFile(path);
                OutputFile.Guarded(path, () =>
                {
                    var ply = new PlyOutput(file.Stream, points);
                    run.Pump(OrderedScan.Run(points, seed, order, ply, run.Progress));
                    ply.Flush();
                });
                file.Commit();
            }
            else
            {
                using var las = new LasReturnSink(path);
                run.Pump(OrderedScan.Run(points, seed, order, las, run.Progress));
                las.Complete();
            }
            run.Progress.Report(1, points, new FileInfo(path).Length);
            run.Progress.End();
        }
    }
}
