namespace FastPoints.HostTests.Editor;

public abstract class EditorFixture
{
    private protected EditorProject m_project;
    private protected readonly List<string> m_logged = new List<string>();

    [SetUp]
    public void OpenProject()
    {
        m_project = new EditorProject();
        m_logged.Clear();
        Debug.s_sink = (type, text) => m_logged.Add(type + ": " + text);
    }

    [TearDown]
    public void CloseProject()
    {
        Debug.s_sink = null;
        var settings = FastPointsSettings.instance;
        (settings.ConvertAtOnce, settings.ConvertOctrees) = (true, false);
        settings.PlayerWarningMiB = 2048;
        settings.SeveralFiles = SeveralFiles.Ask;
        settings.PointFiles = PointFiles.Ask;
        settings.Place = ProjectPaths.DefaultClouds;
        settings.AlwaysInPlayers = [];
        settings.Apply();
        m_project.Dispose();
    }
}
