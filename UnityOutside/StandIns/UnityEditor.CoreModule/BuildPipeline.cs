namespace UnityEditor;

public enum BuildTarget { StandaloneOSX = 2, Android = 13, StandaloneWindows64 = 19, WebGL = 20, StandaloneLinux64 = 24 }

public class BuildPipeline
{
    public static BuildReport BuildPlayer(BuildPlayerOptions buildPlayerOptions) => throw EditorOnly.NotHere(nameof(BuildPlayer));
}

public class EditorUserBuildSettings : UnityEngine.Object
{
    public static BuildTarget activeBuildTarget => BuildTarget.StandaloneLinux64;
}

public class FileUtil
{
    /// <summary>Unity's is relative to the project, in whose folder its process runs.</summary>
    public static string GetPhysicalPath(string path) =>
        Path.Combine(Path.GetDirectoryName(UnityEngine.Application.dataPath), path);

    public static string GetUniqueTempPathInProject() => throw EditorOnly.NotHere(nameof(GetUniqueTempPathInProject));
}
