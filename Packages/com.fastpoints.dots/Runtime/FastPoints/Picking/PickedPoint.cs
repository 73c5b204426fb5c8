using System.Collections.Generic;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>A point of a cloud that a user has picked, with all that the cloud knows of it.</summary>
    public sealed class PickedPoint
    {
        internal PickedPoint(Grid3 place, CloudGrid grid, double3 world, double distance,
            IReadOnlyList<PickedAttribute> attributes)
        {
            Position = place;
            Grid = grid;
            PositionWorld = world;
            Distance = distance;
            Attributes = attributes;
        }

        /// <summary>Exact position in whole steps of <see cref="Grid"/>.</summary>
        public Grid3 Position { get; }

        /// <summary>The grid of the point's cloud.</summary>
        public CloudGrid Grid { get; }

        /// <summary>Georeferenced position in CRS units: the exact one, rounded as every use of the file's own numbers rounds
        /// it.</summary>
        public double3 PositionGeo => Grid.ToGeo(Position);

        /// <summary>Position in the world as the cloud stood when it was picked.</summary>
        public double3 PositionWorld { get; }

        /// <summary>Distance along the ray in world units.</summary>
        public double Distance { get; }

        /// <summary>All attributes of the point except its position, in the order of the source.</summary>
        public IReadOnlyList<PickedAttribute> Attributes { get; }
    }

    internal sealed class PickResult
    {
        // Null if nothing was hit.
        public PickedPoint Point { get; internal set; }

        // The search ended at PickOptions.MaxBytes, so that there may be a nearer point.
        public bool IsPartial { get; internal set; }

        public int NodesRead { get; internal set; }
        public long BytesRead { get; internal set; }
    }
}
