using UnityEngine.Experimental.Rendering;
using UnityOutside.Images;

namespace UnityEngine;

public static class ImageConversion
{
    /// <summary>Textures have their lowest row first, files the highest.</summary>
    public static byte[] EncodeArrayToPNG(Array array, GraphicsFormat format, uint width, uint height, uint rowBytes = 0)
    {
        if (format != GraphicsFormat.R8G8B8A8_SRGB || rowBytes != 0 || array.Length != width * height * 4)
            throw new NotSupportedException(format + ", " + rowBytes + " bytes a row");
        return PngCodec.Encode(Turned((byte[])array, (int)width * 4), (int)width, (int)height);
    }

    /// <returns>False for what is no picture; the texture gets the picture's size.</returns>
    public static bool LoadImage(this Texture2D tex, byte[] data)
    {
        try
        {
            byte[] rgba = PngCodec.Decode(data, out int width, out int height);
            (tex.width, tex.height, tex.Bytes) = (width, height, Turned(rgba, width * 4));
            return true;
        }
        catch (PngException)
        {
            return false;
        }
    }

    static byte[] Turned(byte[] rows, int rowBytes)
    {
        var turned = new byte[rows.Length];
        for (int at = 0; at < rows.Length; at += rowBytes)
            Array.Copy(rows, at, turned, rows.Length - rowBytes - at, rowBytes);
        return turned;
    }
}
