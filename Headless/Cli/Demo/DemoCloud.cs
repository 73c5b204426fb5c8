namespace FastPoints.Cli.Demo;

public static class DemoCloud
{
    public const long DefaultPoints = 5_000_000;
    public const int MaxOrderedPoints = OrderedScan.MaxPoints;

    /// <param name="path">Ends in .las, .laz or .ply; anything else becomes LAS.</param>
    public static void Write(string path, long points, uint seed, ScanOrder order, CliRun run)
    {
        run.Progress.Begin("scan");
        if (Path.GetExtension(path).Equals(".ply", StringComparison.OrdinalIgnoreCase))
        {
            using var file = new OutputFile(path);
            OutputFile.WithFileErrors(path, () =>
            {
                var ply = new PlyOutput(file.Stream, points);
                run.RunSteps(OrderedScan.Run(points, seed, order, ply, run.Progress));
                ply.Flush();
            });
            file.Commit();
        }
        else if (Path.GetExtension(path).Equals(".laz", StringComparison.OrdinalIgnoreCase))
        {
            WriteLaz(path, points, seed, order, run);
        }
        else
        {
            run.RunSteps(LasScan.Run(path, points, seed, order, run.Progress));
        }
        run.Progress.Report(1, points, new FileInfo(path).Length);
        run.Progress.End();
    }

    /// <summary>Writes a temporary LAS file beside it first.</summary>
    static void WriteLaz(string path, long points, uint seed, ScanOrder order, CliRun run)
    {
        string las = path + ".las.tmp";
        try
        {
            run.RunSteps(LasScan.Run(las, points, seed, order, run.Progress));
            run.Progress.End();
            using var reader = PointReaders.Open(las);
            run.RunSteps(ExportCloud.Run(reader, path, new ExportSettings(), _ => { }, run.Progress));
        }
        finally
        {
            File.Delete(las);
        }
    }
}
