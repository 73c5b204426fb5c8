namespace UnityEditor
{
    public struct BuildPlayerOptions
    {
        public string[] scenes { get; set; }
        public string locationPathName { get; set; }
        public BuildTarget target { get; set; }
    }
}

namespace UnityEditor.Build
{
    public interface IOrderedCallback
    {
        int callbackOrder { get; }
    }

    public class BuildFailedException(string message) : Exception(message) { }

    /// <summary>Keeps what would be added.</summary>
    public sealed class BuildPlayerContext
    {
        internal readonly Dictionary<string, string> FolderOfPlayerPath = new Dictionary<string, string>();

        readonly Dictionary<string, string> m_files = new Dictionary<string, string>();

        internal BuildPlayerContext(BuildPlayerOptions options) => BuildPlayerOptions = options;

        public BuildPlayerOptions BuildPlayerOptions { get; }

        /// <summary>What Unity builds: the open scene where the options name none.</summary>
        internal string[] BuiltScenes => BuildPlayerOptions.scenes?.Length > 0 ? BuildPlayerOptions.scenes
            : new[] { UnityEngine.SceneManagement.SceneManager.GetActiveScene().path };

        public void AddAdditionalPathToStreamingAssets(string directoryOrFile, string pathInStreamingAssets = null)
        {
            if (Directory.Exists(directoryOrFile))
                foreach (string file in Directory.GetFiles(directoryOrFile, "*", SearchOption.AllDirectories))
                    Add(file, Path.Combine(pathInStreamingAssets ?? "", Path.GetRelativePath(directoryOrFile, file)));
            else if (File.Exists(directoryOrFile))
                Add(directoryOrFile, pathInStreamingAssets ?? Path.GetFileName(directoryOrFile));
            else
                throw new FileNotFoundException("No such file or directory.", directoryOrFile);
            FolderOfPlayerPath[pathInStreamingAssets ?? ""] = directoryOrFile;
        }

        void Add(string file, string place)
        {
            if (m_files.TryGetValue(place, out string other) && other != file)
                throw new ArgumentException("Unable to add '" + file + "' to StreamingAssets. An entry for '" + place +
                    "' has already been added, '" + other + "'.");
            m_files[place] = file;
        }
    }

    public abstract class BuildPlayerProcessor : IOrderedCallback
    {
        public virtual int callbackOrder => 0;

        public abstract void PrepareForBuild(BuildPlayerContext buildPlayerContext);
    }
}
