using System.Collections.Generic;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>A point of a cloud that somebody has pointed at: all that the cloud knows of it.</summary>
    public sealed class PickedPoint
    {
        internal PickedPoint(Grid3 place, CloudGrid grid, double3 world, double distance,
            IReadOnlyList<PickedAttribute> attributes)
        {
            Place = place;
            Grid = grid;
            PlaceWorld = world;
            Distance = distance;
            Attributes = attributes;
        }

        /// <summary>In whole steps of <see cref="Grid"/>: exact.</summary>
        public Grid3 Place { get; }

        /// <summary>Of the point's cloud.</summary>
        public CloudGrid Grid { get; }

        /// <summary>Georeferenced, in CRS units: the exact place, rounded as every use of the file's own numbers rounds
        /// it.</summary>
        public double3 PlaceGeo => Grid.ToGeo(Place);

        /// <summary>As the cloud stood when it was picked.</summary>
        public double3 PlaceWorld { get; }

        /// <summary>Along the ray, in world units.</summary>
        public double Distance { get; }

        /// <summary>All that the cloud has but the position, in the order of its source.</summary>
        public IReadOnlyList<PickedAttribute> Attributes { get; }
    }

    /// <summary>What a search has come to.</summary>
    internal sealed class PickResult
    {
        /// <summary>Null where nothing was hit.</summary>
        public PickedPoint Point { get; internal set; }

        /// <summary>The search ended at <see cref="PickOptions.MostBytes"/>: there may be a nearer point.</summary>
        public bool IsPartial { get; internal set; }

        public int NodesRead { get; internal set; }
        public long BytesRead { get; internal set; }
    }
}
