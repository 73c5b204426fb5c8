using System;
using System.Text;
using Unity.Entities;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A byte of the paths of a <see cref="PointCloudFile"/>, which <see cref="PointCloudPaths.WriteTo"/> writes.
    /// Copies of an entity, other worlds and subscenes have a buffer of their own, and nobody has to dispose it.</summary>
    [InternalBufferCapacity(0)]
    public struct PointCloudPathByte : IBufferElementData
    {
        /// <summary>Of UTF-8. A 0 ends each path: <see cref="PointCloudPaths.Path"/>,
        /// <see cref="PointCloudPaths.PlayerSource"/>, <see cref="PointCloudPaths.ProjectPath"/>, then
        /// <see cref="PointCloudPaths.ProjectSources"/>.</summary>
        public byte Value;
    }

    /// <summary>Where a cloud is: a converted cloud, with the files that it is made of if these are known, which are shown until
    /// the folder exists. If readers are loaded (<see cref="Feeds.CloudFeeds"/>), it may be any point cloud.</summary>
    public struct PointCloudPaths
    {
        /// <summary>Prefix of a path in an editor if the folder is in the project's <see cref="ConvertedRoot"/>. Importers write
        /// it because they run in a process without the settings, and perhaps on another machine.</summary>
        public const string ConvertedRootPrefix = "<place>/";

        /// <summary>Prefix of the GUID of an asset that is a cloud itself. Moving that to another folder does not import it
        /// again.</summary>
        public const string AssetPrefix = "<asset>/";

        /// <summary>Prefix of a path in an editor if it is below <see cref="SourceRoot"/>.</summary>
        public const string SourcesPrefix = "${FASTPOINTS_SOURCES}/";

        /// <summary>The path of an asset by its GUID, where there is an editor.</summary>
        internal static Func<string, string> PathOfAsset { get; set; }

        /// <summary>Where this user keeps the files that clouds are made of, an absolute path; empty for nowhere. A team's paths
        /// are the same below it.</summary>
        public static string SourceRoot { get; set; } = "";

        /// <summary>Where an editor keeps converted clouds: absolute, or relative to the project.</summary>
        public static string ConvertedRoot { get; set; } = "PointClouds";

        /// <summary>Path of the <c>.fastpoints</c> folder or of another point cloud: absolute, below the application's streaming
        /// assets, or an address of a web server (https).</summary>
        public string Path;

        /// <summary>The file or folder that a player streams directly if <see cref="Path"/> does not exist: absolute, or below
        /// the streaming assets. May be null.</summary>
        public string PlayerSource;

        /// <summary>The folder in an editor, which has no player's data: absolute, relative to the project, or
        /// <see cref="ConvertedRootPrefix"/>. If null, <see cref="Path"/> applies.</summary>
        public string ProjectPath;

        /// <summary>Files and folders that the cloud is made of, in an editor: absolute, relative to the project, or
        /// <see cref="AssetPrefix"/>. May be null.</summary>
        public string[] ProjectSources;

        /// <summary>Writes them to an entity, in place of what was there.</summary>
        /// <param name="buffer">Of an EntityManager, a command buffer or a baker.</param>
        public readonly unsafe void WriteTo(DynamicBuffer<PointCloudPathByte> buffer)
        {
            byte[] bytes = Encoding.UTF8.GetBytes(Path + "\0" + PlayerSource + "\0" + ProjectPath + "\0" +
                (ProjectSources?.Length > 0 ? string.Join("\0", ProjectSources) + "\0" : ""));
            buffer.ResizeUninitialized(bytes.Length);
            bytes.CopyTo(new Span<byte>(buffer.GetUnsafePtr(), bytes.Length));
        }

        internal static PointCloudPaths Of(ReadOnlySpan<byte> bytes)
        {
            string[] all = Encoding.UTF8.GetString(bytes).Split('\0');
            string At(int index) => index < all.Length ? all[index] : "";
            return new PointCloudPaths
            {
                Path = At(0),
                PlayerSource = At(1),
                ProjectPath = At(2),
                ProjectSources = all.Length > 4 ? all.AsSpan(3, all.Length - 4).ToArray() : new string[0],
            };
        }

        internal static unsafe ReadOnlySpan<byte> BytesOf(DynamicBuffer<PointCloudPathByte> buffer) =>
            new ReadOnlySpan<byte>(buffer.GetUnsafeReadOnlyPtr(), buffer.Length);

        /// <summary>The folder's absolute path.</summary>
        public readonly string FullPath => Application.isEditor && !string.IsNullOrEmpty(ProjectPath)
            ? InProject(ProjectPath)
            : InStreamingAssets(Path ?? "");

        /// <summary>Absolute paths of what the cloud is made of; empty if unknown.</summary>
        public readonly string[] FullSources()
        {
            if (Application.isEditor && !string.IsNullOrEmpty(ProjectPath))
                return ProjectSources == null ? new string[0] : Array.ConvertAll(ProjectSources, InProject);
            return string.IsNullOrEmpty(PlayerSource) ? new string[0]
                : new[] { InStreamingAssets(PlayerSource) };
        }

        static string InStreamingAssets(string path) =>
            SourcePath.IsRemote(path) ? path : System.IO.Path.Combine(Application.streamingAssetsPath, path);

        static string InProject(string path)
        {
            if (SourcePath.IsRemote(path))
                return path;
            if (path.StartsWith(ConvertedRootPrefix, StringComparison.Ordinal))
                path = System.IO.Path.Combine(ConvertedRoot, path.Substring(ConvertedRootPrefix.Length));
            else if (path.StartsWith(AssetPrefix, StringComparison.Ordinal))
                path = PathOfAsset(path.Substring(AssetPrefix.Length));
            if (path.StartsWith(SourcesPrefix, StringComparison.Ordinal))
                path = System.IO.Path.Combine(SourceRoot, path.Substring(SourceRoot.Length > 0 ? SourcesPrefix.Length : 0));
            return System.IO.Path.GetFullPath(
                System.IO.Path.Combine(System.IO.Path.GetDirectoryName(Application.dataPath), path));
        }
    }
}
