using Unity.Mathematics;

namespace FastPoints.Scenes
{
    internal enum SceneShape : byte
    {
        House, // Walls with windows under a gable roof; its ridge runs along the object's x axis.
        Pole,
        Crown, // An ellipsoid filled with leaves: a pulse enters it and may return several times.
        Box,
    }

    /// <summary>One object of the scene, in the scene's own metres (x east, y north, z up).</summary>
    internal struct SceneObject
    {
        public float3 Center; // Middle of the base; middle of the body for a crown.

        /// <summary>Half the extent in the object's own axes; radius in x for a pole. For houses z is the eaves' height, for
        /// poles and boxes the height.</summary>
        public float3 Half;
        public float2 Heading; // The object's x axis in the plane: cosine and sine of its heading.

        public float3 Color;
        public float Slope; // Rise of a house's roof over half its width; leaves a metre of path for a crown.

        public uint Seed;
        public SceneShape Shape;
        public byte Classification; // ASPRS class of its returns (a house's glass and a car have their own).

        /// <summary>Radius in the plane around <see cref="Center"/> that contains it.</summary>
        public float Reach
        {
            get
            {
                return Shape switch
                {
                    SceneShape.Pole => Half.x,
                    SceneShape.Crown => math.max(Half.x, Half.y),
                    _ => math.length(Half.xy) + 1.2f,
                };
            }
        }
    }
}
