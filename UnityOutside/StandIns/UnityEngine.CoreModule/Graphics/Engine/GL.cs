namespace UnityEngine;

public sealed class GL
{
    /// <summary>A projection as the device takes it: near is 1 and far 0, and what is drawn into a texture is upside down, so
    /// that a texture's first row is a picture's lowest.</summary>
    public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 proj, bool renderIntoTexture)
    {
        proj.SetRow(2, (proj.GetRow(3) - proj.GetRow(2)) * 0.5f);
        if (renderIntoTexture)
            proj.SetRow(1, -proj.GetRow(1));
        return proj;
    }
}
