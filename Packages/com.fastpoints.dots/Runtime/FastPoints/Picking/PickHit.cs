using FastPoints.Core;

namespace FastPoints.Picking
{
    internal struct PickHit
    {
        // World units along the ray; infinity if nothing was found.
        public double Distance;
        public double RayDistanceSq;

        // On the cloud's grid.
        public Grid3 Place;
        public int Page;

        // Its planes hold the point.
        public int Node;
        public int Block;

        // In its block.
        public int Index;

        public static PickHit None => new PickHit { Distance = double.PositiveInfinity };

        public readonly bool IsFound => Distance < double.PositiveInfinity;

        // Nearer to the camera, or, at equal distance, nearer to the ray. Ties are decided by position, so that no reading
        // order matters; of several points at one position, the first one wins.
        public readonly bool IsBefore(in PickHit other)
        {
            if (Distance != other.Distance)
                return Distance < other.Distance;
            if (RayDistanceSq != other.RayDistanceSq)
                return RayDistanceSq < other.RayDistanceSq;
            if (Place.X != other.Place.X)
                return Place.X < other.Place.X;
            if (Place.Y != other.Place.Y)
                return Place.Y < other.Place.Y;
            if (Place.Z != other.Place.Z)
                return Place.Z < other.Place.Z;
            if (Page != other.Page)
                return Page < other.Page;
            return Node != other.Node ? Node < other.Node : Block != other.Block ? Block < other.Block : Index < other.Index;
        }
    }
}
