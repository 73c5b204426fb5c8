namespace FastPoints.Cli.Convert;

public sealed class NormalsStep
{
    string m_orientation = "";
    double m_seconds;

    public long Points { get; private set; }

    public static NormalsStep Run(string cloud, CliRun run)
    {
        double begin = run.Seconds;
        var step = new NormalsStep();
        JobCoroutine.RunToEnd(AddNormals.Run(cloud, null, manifest =>
            (step.Points, step.m_orientation) = (manifest.Points, manifest.NormalOrientation), run.Progress), run.Cancellation);
        step.m_seconds = run.Seconds - begin;
        return step;
    }

    public string Describe() => "normals of " + NumberFormat.Count(Points, "point") + " in " + NumberFormat.Seconds(m_seconds)
        + (m_orientation == NormalOrientations.Up ? ", which point up"
        : m_orientation == NormalOrientations.Scanner ? ", which point to the scanner"
        : m_orientation == NormalOrientations.OfSource ? ", which are those of the files" : ", which are turned to the viewer");

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteStartObject("normals");
        json.WriteInteger("points", Points);
        json.WriteReal("seconds", m_seconds);
        json.WriteString("orientation", m_orientation);
        json.WriteEndObject();
    }
}
