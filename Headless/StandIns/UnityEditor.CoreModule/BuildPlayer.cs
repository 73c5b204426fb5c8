using System;
using System.Collections.Generic;

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

    public class BuildFailedException : Exception
    {
        public BuildFailedException(string message)
            : base(message)
        {
        }
    }

    /// <summary>Keeps what would be added.</summary>
    public sealed class BuildPlayerContext
    {
        internal readonly Dictionary<string, string> FolderOfPlayerPath = new Dictionary<string, string>();

        internal BuildPlayerContext(BuildPlayerOptions options)
        {
            BuildPlayerOptions = options;
        }

        public BuildPlayerOptions BuildPlayerOptions { get; }

        public void AddAdditionalPathToStreamingAssets(string directoryOrFile, string pathInStreamingAssets = null) =>
            FolderOfPlayerPath.Add(pathInStreamingAssets ?? "", directoryOrFile);
    }

    public abstract class BuildPlayerProcessor : IOrderedCallback
    {
        public virtual int callbackOrder => 0;

        public abstract void PrepareForBuild(BuildPlayerContext buildPlayerContext);
    }
}
