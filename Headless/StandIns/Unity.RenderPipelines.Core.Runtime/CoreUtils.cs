using System;

namespace UnityEngine.Rendering;

[Flags]
public enum ClearFlag { None = 0 }

public static class CoreUtils
{
    public static void SetRenderTarget(CommandBuffer cmd, RTHandle colorBuffer, RTHandle depthBuffer, ClearFlag clearFlag,
        int miplevel = 0, CubemapFace cubemapFace = CubemapFace.Unknown, int depthSlice = -1) =>
        cmd.SetRenderTarget(colorBuffer, depthBuffer, miplevel, cubemapFace, depthSlice);
}
