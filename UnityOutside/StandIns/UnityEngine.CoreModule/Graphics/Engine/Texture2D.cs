namespace UnityEngine;

public enum TextureFormat { RGBA32 = 4 }

/// <summary>Pixels to look at; no shader sees them.</summary>
public sealed class Texture2D : Texture
{
    internal byte[] Bytes;

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
    {
        this.width = width;
        this.height = height;
        Bytes = new byte[width * height * 4];
    }

    public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
        MemoryMarshal.AsBytes(data.AsSpan(sourceDataStartIndex)).Slice(0, Bytes.Length).CopyTo(Bytes);

    public Color32[] GetPixels32() => MemoryMarshal.Cast<byte, Color32>(Bytes).ToArray();

    public void Apply() { }
}
