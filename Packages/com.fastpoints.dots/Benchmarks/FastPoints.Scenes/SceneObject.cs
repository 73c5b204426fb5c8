using Unity.Mathematics;

namespace FastPoints.Scenes
{
    internal enum SceneShape : byte
    {
        /// <summary>Walls with windows under a gable roof; its ridge runs along the object's x axis.</summary>
        House,
        Pole,
        /// <summary>An ellipsoid filled with leaves: a pulse enters it and may return several times.</summary>
        Crown,
        Box,
    }

    /// <summary>One object of the scene, in the scene's own metres (x east, y north, z up).</summary>
    internal struct SceneObject
    {
        /// <summary>Middle of the base; middle of the body for a crown.</summary>
        public float3 Center;

        /// <summary>Half the extent in the object's own axes; radius in x for a pole. For houses z is the eaves' height, for
        /// poles and boxes the height.</summary>
        public float3 Half;

        /// <summary>The object's x axis in the plane: cosine and sine of its heading.</summary>
        public float2 Heading;

        public float3 Color;

        /// <summary>Rise of a house's roof over half its width; leaves a metre of path for a crown.</summary>
        public float Slope;

        public uint Seed;
        public SceneShape Shape;

        /// <summary>ASPRS class of its returns (a house's glass and a car have their own).</summary>
        public byte Classification;

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
