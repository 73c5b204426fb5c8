using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A cloud that scenes refer to: where its files and its converted folder are, and what is known of it. It contains
    /// no points. The editor makes it from a <c>.pointcloud</c> handle or from a file in <c>Assets</c>.</summary>
    [HelpPage("import")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloudAsset : ScriptableObject
    {
        /// <summary>The folder in an editor: relative to the project with '/', absolute, or
        /// <see cref="PointCloudPaths.ConvertedRootPrefix"/>.</summary>
        public string ProjectPath;

        /// <summary>The folder below a player's streaming assets.</summary>
        public string PlayerPath;

        /// <summary>Files and folders that the cloud is made of, in an editor: relative to the project with '/', absolute, or
        /// <see cref="PointCloudPaths.AssetPrefix"/>. They are shown until there is a converted folder.</summary>
        public string[] ProjectSources = new string[0];

        /// <summary>The source below a player's streaming assets if the cloud can be streamed without conversion; otherwise
        /// empty.</summary>
        public string PlayerSource;

        /// <summary>Number of points; -1 if unknown.</summary>
        public long Points = -1;

        /// <summary>Georeferenced, in CRS units. The minimum exceeds the maximum if the bounds are unknown.</summary>
        public double3 BoundsMin;
        public double3 BoundsMax;

        /// <summary>Name of the coordinate system in one line; empty if unknown.</summary>
        public string Crs;

        /// <summary>Metres of a horizontal unit; 0 if unknown, NaN for degrees.</summary>
        public double MetresPerUnit;

        /// <summary>Metres of a vertical unit; 0 if nothing says it.</summary>
        public double VerticalMetresPerUnit;

        /// <summary>Metres of a unit as set by the user, overriding the file; 0 if not set.</summary>
        public double MetresPerUnitOverride;

        /// <summary>The axis that points up.</summary>
        public UpAxis Up = UpAxis.Z;

        /// <summary>Whether <see cref="Origin"/> is known: where the cloud was first shown, so that another conversion moves
        /// nothing.</summary>
        public bool HasOrigin;

        /// <summary>The position that transforms move, georeferenced, in CRS units.</summary>
        public double3 Origin;

        /// <summary>The user's, or else the file's.</summary>
        public CloudUnits Units => MetresPerUnitOverride > 0 ? new CloudUnits(MetresPerUnitOverride)
            : new CloudUnits(MetresPerUnit, VerticalMetresPerUnit);

        /// <summary>Where an entity finds the cloud.</summary>
        public PointCloudPaths Paths => new PointCloudPaths
        {
            Path = PlayerPath,
            PlayerSource = PlayerSource,
            ProjectPath = ProjectPath,
            ProjectSources = ProjectSources,
        };

        /// <summary>What an entity needs besides <see cref="Paths"/> to stream the cloud.</summary>
        public PointCloudFile File() => new PointCloudFile
        {
            HasOrigin = HasOrigin,
            OriginGeo = Origin,
            Up = Up,
            MetresPerUnitOverride = MetresPerUnitOverride,
        };

        /// <summary>The space that a transform moves.</summary>
        /// <returns>False if the bounds are unknown.</returns>
        public bool TryGetSpace(out BoundsGeo bounds, out UnityLocalSpace space)
        {
            bounds = new BoundsGeo(BoundsMin, BoundsMax);
            space = UnityLocalSpace.Of(bounds, Units, Up);
            if (HasOrigin)
                space.OriginGeo = Origin;
            return !bounds.IsEmpty && bounds.IsFinite;
        }
    }
}
