namespace FastPoints.Cli.Convert;

public sealed class ConvertStep(CliRun run)
{
    public required ConvertResult Result { get; init; }
    public required JobDurations Slices { get; init; }
    public required double Seconds { get; init; }

    public static ConvertStep Run(IReadOnlyList<PointReader> readers, string target, ConvertSettings settings, CliRun run)
    {
        double begin = run.Seconds;
        ConvertResult? result = null;
        JobDurations slices;
        // RunToEnd waits for jobs, so none are scheduled ahead to fill the time between ticks.
        settings.InFlightMs = 0;
        if (run.IsDiscarding)
            CloudFolderWriter.DeleteUnfinished(target);
        // Set before cancelling: the build keeps its files if it was stopped, not if it failed.
        using var stop = new CancellationTokenSource();
        using var stopping = run.Cancellation.Register(() =>
        {
            settings.KeepUnfinished = !run.IsDiscarding;
            // In the last stage only the rename is left, and it may be done before the build sees the cancellation.
            if (run.IsDiscarding || run.Progress.Current != BuildStages.Finish)
                stop.Cancel();
        });
        try
        {
            slices = JobDurations.Measure(() => JobCoroutine.RunToEnd(
                ConvertCloud.Run(readers, target, settings, r => result = r, run.Progress), stop.Token));
        }
        catch (OperationCanceledException)
        {
            // A build can be resumed only if its points are in files.
            string part = Path.TrimEndingDirectorySeparator(target) + StoreFormat.UnfinishedSuffix;
            if (File.Exists(Path.Combine(part, BuildFiles.JournalName)) && !run.IsDiscarding)
                throw new StoppedException(target, run.CommandLine);
            CloudFolderWriter.DeleteUnfinished(target);
            throw;
        }
        foreach (var reader in readers)
        {
            run.Warn(reader.Info);
            run.Report(reader.Info.Losses);
        }
        if (result!.Manifest.PointsLeftOut > 0)
            run.Warn(readers[0].Info.ShownPath + ": " + NumberFormat.Count(result.Manifest.PointsLeftOut)
                + " points whose coordinates are no numbers are left out");
        return new ConvertStep(run) { Result = result, Slices = slices, Seconds = run.Seconds - begin };
    }

    public long PointsFound => Result.Manifest.Points + Result.Manifest.PointsLeftOut;

    public string Describe()
    {
        var manifest = Result.Manifest;
        string leftOut = manifest.PointsLeftOut > 0 ? ", " + NumberFormat.Count(manifest.PointsLeftOut) + " left out" : "";
        string perPoint = manifest.Points > 0
            ? " (" + NumberFormat.Value(System.Math.Round(Result.BytesOnDisk / (double)manifest.Points, 2)) + " bytes a point)"
            : "";
        string note = Result.Note == null ? "" : " (" + Result.Note + ")";
        return NumberFormat.Count(manifest.Points, "point") + leftOut + " in " + NumberFormat.Count(manifest.NodeCount, "node")
            + ", " + NumberFormat.Bytes(Result.BytesOnDisk) + perPoint + ", in " + NumberFormat.Seconds(Seconds) + note;
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        var manifest = Result.Manifest;
        json.WriteInteger("points", manifest.Points);
        json.WriteInteger("pointsLeftOut", manifest.PointsLeftOut);
        json.WriteInteger("nodes", manifest.NodeCount);
        json.WriteInteger("levelCount", Result.LevelCount);
        json.WriteInteger("bytesOnDisk", Result.BytesOnDisk);
        json.WriteInteger("temporaryBytesPeak", Result.TemporaryBytesPeak);
        Slices.WriteKey(json);
        json.WriteString("checksum", manifest.Checksum.ToString("x16", CultureInfo.InvariantCulture));
        json.WriteStartObject("bytesPerPoint");
        foreach (var (name, bytes) in Result.PlaneNames.Zip(Result.BytesOfPlane))
            json.WriteReal(name, manifest.Points > 0 ? bytes / (double)manifest.Points : 0);
        json.WriteEndObject();
        run.WriteLosses(json);
    }
}
