using FastPoints.Gpu;
using FastPoints.Picture;
using Unity.Entities;
using UnityEngine;
using Gradient = FastPoints.Picture.Gradient;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud on disk: an entity with this, and a transform, is opened and streamed.</summary>
    public sealed class PointCloudFile : IComponentData
    {
        /// <summary>Of the <c>.fastpoints</c> folder: absolute, or below the application's streaming assets.</summary>
        public string Path;

        /// <summary>Where the folder is in an editor, which has no player's data: absolute, or in the project. Null for
        /// <see cref="Path"/>.</summary>
        public string ProjectPath;

        /// <summary>What points are coloured by; another where the cloud has nothing for it. Looked at when it is opened, as are
        /// the others: only what they need is streamed.</summary>
        public ColorMode Color;
        public Gradient Gradient;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>What went wrong when it was opened; null where nothing did.</summary>
        public string Error;

        /// <summary>The folder's whole path.</summary>
        public string FullPath => Application.isEditor && !string.IsNullOrEmpty(ProjectPath)
            ? System.IO.Path.Combine(System.IO.Path.GetDirectoryName(Application.dataPath), ProjectPath)
            : System.IO.Path.Combine(Application.streamingAssetsPath, Path ?? "");
    }
}
