namespace FastPoints.Cli.Output;

public static class StageTable
{
    public static TextTable Of(StageProgress progress, int first = 0)
    {
        var table = new TextTable("stage", "seconds", "points", "points/s", "MB/s");
        double seconds = 0;
        foreach (var stage in progress.Finished.Skip(first))
        {
            seconds += stage.Seconds;
            table.Add(stage.Name, stage.Seconds.ToString("0.000", CultureInfo.InvariantCulture),
                stage.Points > 0 ? NumberFormat.Count(stage.Points) : "",
                stage.Points > 0 && stage.Seconds > 0 ? NumberFormat.Short(stage.Points / stage.Seconds) : "",
                stage.Bytes > 0 && stage.Seconds > 0
                    ? (stage.Bytes / stage.Seconds / 1e6).ToString("N0", CultureInfo.InvariantCulture)
                    : "");
        }
        table.Add("together", seconds.ToString("0.000", CultureInfo.InvariantCulture));
        return table;
    }
}
