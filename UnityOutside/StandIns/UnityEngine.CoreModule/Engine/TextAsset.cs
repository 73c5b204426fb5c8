namespace UnityEngine;

public class TextAsset : Object
{
    internal byte[] Content;

    public byte[] bytes => (byte[])Content.Clone();
}
