using FastPoints.Gpu;
using FastPoints.Picture;
using FastPoints.Points;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using Gradient = FastPoints.Picture.Gradient;

namespace FastPoints.Entities
{
    /// <summary>A cloud on disk: an entity with this, and a transform, is opened and streamed. A converted one, and what it is
    /// made of where that is known: shown until the folder is there. Or, where readers are loaded
    /// (<see cref="Feeds.CloudFeeds"/>), any point cloud.</summary>
    public sealed class PointCloudFile : IComponentData
    {
        /// <summary>What a path in an editor begins with where the folder is in the project's <see cref="Place"/>. What imports
        /// an asset writes this: it runs in a process that knows no settings, and perhaps on another machine.</summary>
        public const string InPlace = "<place>/";

        /// <summary>Where an editor has converted clouds: absolute, or in the project.</summary>
        public static string Place { get; set; } = "PointClouds";

        /// <summary>Of the <c>.fastpoints</c> folder, or of another point cloud: absolute, or below the application's streaming
        /// assets.</summary>
        public string Path;

        /// <summary>Where the folder is in an editor, which has no player's data: absolute, in the project, or
        /// <see cref="InPlace"/>. Null for <see cref="Path"/>.</summary>
        public string ProjectPath;

        /// <summary>Files and folders that the cloud is made of, in an editor: absolute, or in the project. May be
        /// null.</summary>
        public string[] ProjectSources;

        /// <summary>The file or folder that a player streams as it is where <see cref="Path"/> is not there: absolute, or below
        /// the streaming assets. May be null.</summary>
        public string PlayerSource;

        /// <summary>Whether <see cref="OriginGeo"/> is the place that the transform moves; otherwise what is shown first
        /// decides.</summary>
        public bool HasOrigin;

        /// <summary>Georeferenced, CRS units.</summary>
        public double3 OriginGeo;

        /// <summary>The cloud's axis that points up.</summary>
        public UpAxis Up = UpAxis.Z;

        /// <summary>Metres of a unit, where the file does not say or is wrong; 0 for what it says.</summary>
        public double UnitMetres;

        /// <summary>What points are coloured by; another where the cloud has nothing for it. Looked at when it is opened, as are
        /// the others: only what they need is streamed.</summary>
        public ColorMode Color;
        public Gradient Gradient;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>What went wrong when it was opened; null where nothing did.</summary>
        public string Error;

        /// <summary>Somebody knows of something new on disk: it is looked for, what is shown stays until it is there. Goes back
        /// to false.</summary>
        public bool LooksAgain;

        /// <summary>The folder's whole path.</summary>
        public string FullPath => Application.isEditor && !string.IsNullOrEmpty(ProjectPath)
            ? InProject(ProjectPath)
            : System.IO.Path.Combine(Application.streamingAssetsPath, Path ?? "");

        /// <summary>Whole paths of what the cloud is made of; none where nobody knows.</summary>
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
            return System.IO.Path.Combine(System.IO.Path.GetDirectoryName(Application.dataPath), path);
        }
    }
}
