namespace UnityEngine;

public struct Color32
{
    public byte r, g, b, a;
}
