namespace StandIns.Graphics;

sealed unsafe class NativeStrings : IDisposable
{
    readonly List<IntPtr> m_blocks = new List<IntPtr>();

    public void Dispose()
    {
        foreach (IntPtr block in m_blocks)
            Marshal.FreeHGlobal(block);
        m_blocks.Clear();
    }

    internal static string Read(byte* text) => Marshal.PtrToStringAnsi((IntPtr)text) ?? "";

    internal byte* Text(string text)
    {
        IntPtr block = Marshal.StringToHGlobalAnsi(text);
        m_blocks.Add(block);
        return (byte*)block;
    }

    internal byte** Array(params string[] texts)
    {
        IntPtr block = Marshal.AllocHGlobal(Math.Max(1, texts.Length) * sizeof(byte*));
        m_blocks.Add(block);
        for (int i = 0; i < texts.Length; i++)
            ((byte**)block)[i] = Text(texts[i]);
        return (byte**)block;
    }
}
