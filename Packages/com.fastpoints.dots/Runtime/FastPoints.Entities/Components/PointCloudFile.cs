using FastPoints.Gpu;
using FastPoints.Picture;
using FastPoints.Points;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using Gradient = FastPoints.Picture.Gradient;

namespace FastPoints.Entities
{
    /// <summary>A cloud on disk: an entity with this and a transform is opened and streamed. It is a converted cloud, with the
    /// files that it is made of if these are known, which are shown until the folder exists. If readers are loaded
    /// (<see cref="Feeds.CloudFeeds"/>), it may be any point cloud.</summary>
    public sealed class PointCloudFile : IComponentData
    {
        /// <summary>Prefix of a path in an editor if the folder is in the project's <see cref="Place"/>. Importers write it
        /// because they run in a process without the settings, and perhaps on another machine.</summary>
        public const string InPlace = "<place>/";

        /// <summary>Prefix of the number of an asset that is a cloud itself. Moving that to another folder does not import it
        /// again.</summary>
        public const string OfAsset = "<asset>/";

        /// <summary>The path of an asset by its number, where there is an editor.</summary>
        internal static System.Func<string, string> PathOfAsset { get; set; }

        /// <summary>Prefix of a path in an editor if it is below <see cref="SourceRoot"/>.</summary>
        public const string InSources = "${FASTPOINTS_SOURCES}/";

        /// <summary>Where this user keeps the files that clouds are made of, an absolute path; empty for nowhere. A team's paths
        /// are the same below it.</summary>
        public static string SourceRoot { get; set; } = "";

        /// <summary>Where an editor keeps converted clouds: absolute, or relative to the project.</summary>
        public static string Place { get; set; } = "PointClouds";

        /// <summary>Path of the <c>.fastpoints</c> folder or of another point cloud: absolute, or below the application's
        /// streaming assets.</summary>
        public string Path;

        /// <summary>The folder in an editor, which has no player's data: absolute, relative to the project, or
        /// <see cref="InPlace"/>. If null, <see cref="Path"/> applies.</summary>
        public string ProjectPath;

        /// <summary>Files and folders that the cloud is made of, in an editor: absolute, relative to the project, or
        /// <see cref="OfAsset"/>. May be null.</summary>
        public string[] ProjectSources;

        /// <summary>The file or folder that a player streams directly if <see cref="Path"/> does not exist: absolute, or below
        /// the streaming assets. May be null.</summary>
        public string PlayerSource;

        /// <summary>Whether <see cref="OriginGeo"/> is the place that the transform moves; otherwise the first shown state
        /// decides.</summary>
        public bool HasOrigin;

        /// <summary>The origin, georeferenced, in CRS units.</summary>
        public double3 OriginGeo;

        /// <summary>That of the <see cref="PointCloud"/> that places it; null for none.</summary>
        internal GameObject GameObject;

        /// <summary>The cloud's axis that points up.</summary>
        public UpAxis Up = UpAxis.Z;

        /// <summary>Metres of a unit, if the file does not say or is wrong; 0 to use what it says.</summary>
        public double UnitMetres;

        /// <summary>What points are coloured by; a cloud without these values chooses another mode. Only what
        /// this and the other fields need is streamed: a change opens the cloud again.</summary>
        public ColorMode Color;
        public Gradient Gradient;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>The error of opening the cloud; null if there was none.</summary>
        public string Error;

        /// <summary>Set it if there may be newer data on disk: this is looked for, and what is shown stays until it is ready. It
        /// resets to false.</summary>
        public bool LooksAgain;

        internal PointCloudFile Copy() => (PointCloudFile)MemberwiseClone();

        /// <summary>Whether a cloud opened as this says is as another says, but for its place.</summary>
        internal bool OpensLike(PointCloudFile other) => Path == other.Path && ProjectPath == other.ProjectPath &&
            PlayerSource == other.PlayerSource &&
            System.MemoryExtensions.SequenceEqual<string>(ProjectSources, other.ProjectSources) && Color == other.Color &&
            Gradient == other.Gradient && HiddenClasses.Equals(other.HiddenClasses) && Up == other.Up &&
            UnitMetres.Equals(other.UnitMetres) && (other.HasOrigin || !HasOrigin);

        /// <summary>The folder's absolute path.</summary>
        public string FullPath => Application.isEditor && !string.IsNullOrEmpty(ProjectPath)
            ? InProject(ProjectPath)
            : System.IO.Path.Combine(Application.streamingAssetsPath, Path ?? "");

        /// <summary>Absolute paths of what the cloud is made of; empty if unknown.</summary>
        public string[] FullSources()
        {
            if (Application.isEditor && !string.IsNullOrEmpty(ProjectPath))
                return ProjectSources == null ? new string[0] : System.Array.ConvertAll(ProjectSources, InProject);
            return string.IsNullOrEmpty(PlayerSource) ? new string[0]
                : new[] { System.IO.Path.Combine(Application.streamingAssetsPath, PlayerSource) };
        }

        static string InProject(string path)
        {
            if (path.StartsWith(InPlace, System.StringComparison.Ordinal))
                path = System.IO.Path.Combine(Place, path.Substring(InPlace.Length));
            else if (path.StartsWith(OfAsset, System.StringComparison.Ordinal))
                path = PathOfAsset(path.Substring(OfAsset.Length));
            if (path.StartsWith(InSources, System.StringComparison.Ordinal))
                path = System.IO.Path.Combine(SourceRoot, path.Substring(SourceRoot.Length > 0 ? InSources.Length : 0));
            return System.IO.Path.GetFullPath(
                System.IO.Path.Combine(System.IO.Path.GetDirectoryName(Application.dataPath), path));
        }
    }
}
