using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>Where a pulse meets something solid.</summary>
    public struct SceneHit
    {
        /// <summary>Metres along the ray; infinity where it meets nothing.</summary>
        public float Distance;

        public float3 Normal;

        /// <summary>Linear colour of the material, unlit.</summary>
        public float3 Color;

        /// <summary>Share of the infrared light that comes back at normal incidence.</summary>
        public float Reflectance;

        public byte Classification;

        /// <summary>The pulse ends here, and nothing of it returns: glass that mirrors it away.</summary>
        public bool IsLost;

        public static SceneHit None => new SceneHit { Distance = float.PositiveInfinity };
    }
}
