namespace UnityEngine
{
    public sealed class Light : Behaviour
    {
        public Color color { get; set; } = Color.white;
        public float intensity { get; set; } = 1;
    }

    public enum LightType
    {
        Spot,
        Directional,
        Point,
    }

    public sealed class RenderSettings : Object
    {
        public static Light sun { get; set; }
        public static SphericalHarmonicsL2 ambientProbe { get; set; }
    }
}

namespace UnityEngine.Rendering
{
    public unsafe struct SphericalHarmonicsL2
    {
        const int CoefficientsOfChannel = 9;

        Channels m_channels;

        public float this[int rgb, int coefficient]
        {
            readonly get => m_channels.Values[rgb * CoefficientsOfChannel + coefficient];
            set => m_channels.Values[rgb * CoefficientsOfChannel + coefficient] = value;
        }

        struct Channels
        {
            public fixed float Values[3 * CoefficientsOfChannel];
        }
    }

    public struct VisibleLight
    {
        public Color finalColor { readonly get; set; }
        public LightType lightType { readonly get; set; }
        public Matrix4x4 localToWorldMatrix { readonly get; set; }
        public float range { readonly get; set; }

        /// <summary>Of the whole cone, in degrees.</summary>
        public float spotAngle { readonly get; set; }
    }
}
