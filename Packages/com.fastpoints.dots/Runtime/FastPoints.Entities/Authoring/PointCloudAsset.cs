using FastPoints.Points;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A cloud that scenes refer to: where its files and its converted folder are, and what is known of it. Of the
    /// points there is nothing in it. The editor makes it, of a <c>.pointcloud</c> handle or of a file in
    /// <c>Assets</c>.</summary>
    public sealed class PointCloudAsset : ScriptableObject
    {
        /// <summary>The folder in an editor: in the project, with '/', absolute, or
        /// <see cref="PointCloudFile.InPlace"/>.</summary>
        public string ProjectPath;

        /// <summary>The folder below a player's streaming assets.</summary>
        public string PlayerPath;

        /// <summary>Files and folders that the cloud is made of, in an editor: in the project, with '/', or absolute. Shown until
        /// there is a converted folder.</summary>
        public string[] ProjectSources = new string[0];

        /// <summary>Below a player's streaming assets, where the cloud can be streamed without conversion; empty where it
        /// cannot.</summary>
        public string PlayerSource;

        /// <summary>-1 where nobody has counted them.</summary>
        public long Points = -1;

        /// <summary>Georeferenced, in CRS units. The minimum exceeds the maximum where they are not known.</summary>
        public double3 BoundsMin;
        public double3 BoundsMax;

        /// <summary>One line; empty where it is not known.</summary>
        public string Crs;

        /// <summary>Metres of a horizontal unit; 0 where unknown, NaN where it is an angle.</summary>
        public double MetresPerUnit;

        /// <summary>Metres of a unit as somebody has set it, whatever the file says; 0 where nobody has.</summary>
        public double UnitMetres;

        /// <summary>The axis that points up.</summary>
        public UpAxis Up = UpAxis.Z;

        /// <summary>Whether <see cref="Origin"/> is known: where the cloud was shown first, so that another conversion moves
        /// nothing.</summary>
        public bool HasOrigin;

        /// <summary>Georeferenced, in CRS units: the place that transforms move.</summary>
        public double3 Origin;

        /// <summary>What an entity says to have the cloud streamed.</summary>
        public PointCloudFile File() => new PointCloudFile
        {
            Path = PlayerPath,
            ProjectPath = ProjectPath,
            ProjectSources = ProjectSources,
            PlayerSource = PlayerSource,
            HasOrigin = HasOrigin,
            OriginGeo = Origin,
            Up = Up,
            UnitMetres = UnitMetres,
        };

        /// <summary>The space that a transform moves.</summary>
        /// <returns>False where the bounds are not known.</returns>
        public bool TryGetSpace(out BoundsGeo bounds, out UnitySpace space)
        {
            bounds = new BoundsGeo(BoundsMin, BoundsMax);
            space = UnitySpace.Of(bounds, UnitMetres > 0 ? UnitMetres : MetresPerUnit, Up);
            if (HasOrigin)
                space.OriginGeo = Origin;
            return !bounds.IsEmpty && bounds.IsFinite;
        }
    }
}
