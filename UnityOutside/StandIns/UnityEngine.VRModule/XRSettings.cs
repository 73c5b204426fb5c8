[assembly: System.Runtime.CompilerServices.InternalsVisibleTo("HostTests")]

namespace UnityEngine.XR;

public static class XRSettings
{
    /// <summary>What a headset's eyes are drawn into: an array of two if both are drawn at once. Without a headset there is no
    /// such texture.</summary>
    public static RenderTextureDescriptor eyeTextureDesc { get; internal set; }
}
