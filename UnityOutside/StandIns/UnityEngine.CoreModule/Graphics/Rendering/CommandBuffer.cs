namespace UnityEngine.Rendering;

/// <summary>A list of commands, done when Graphics.ExecuteCommandBuffer is called, as often as it is. Cleared and filled again it
/// makes no garbage.</summary>
public partial class CommandBuffer : IDisposable
{
    internal readonly List<RecordedCommand> Commands = new List<RecordedCommand>();
    internal readonly List<PropertyValue> Values = new List<PropertyValue>();
    internal readonly List<RenderTargetIdentifier> Targets = new List<RenderTargetIdentifier>();
    internal readonly List<RenderTextureDescriptor> Descriptors = new List<RenderTextureDescriptor>();
    readonly List<PropertySheet> m_sheets = new List<PropertySheet>();
    int m_sheetsUsed;
    bool m_isReleased;

    public string name { get; set; } = "";
    internal byte[] Bytes { get; private set; } = Array.Empty<byte>();

    int BytesUsed { get; set; }

    public void Clear()
    {
        CheckReleased();
        Commands.Clear();
        Values.Clear();
        Targets.Clear();
        Descriptors.Clear();
        m_sheetsUsed = 0;
        BytesUsed = 0;
    }

    public void Dispose() => m_isReleased = true;

    internal void CheckReleased()
    {
        if (m_isReleased)
            throw new ObjectDisposedException($"CommandBuffer {name}");
    }

    void Add(in RecordedCommand command)
    {
        CheckReleased();
        Commands.Add(command);
    }

    int AddValue(in PropertyValue value)
    {
        Values.Add(value);
        return Values.Count - 1;
    }

    int AddTarget(RenderTargetIdentifier target)
    {
        Targets.Add(target);
        return Targets.Count - 1;
    }

    // A property block counts as it is now: what is done to it afterwards does not change the draw.
    PropertySheet AddSheet(MaterialPropertyBlock block)
    {
        if (block == null)
            return null;
        if (m_sheetsUsed == m_sheets.Count)
            m_sheets.Add(new PropertySheet());
        PropertySheet sheet = m_sheets[m_sheetsUsed++];
        sheet.CopyFrom(block.Sheet);
        return sheet;
    }

    unsafe int AddBytes(byte* data, long bytes)
    {
        int start = BytesUsed;
        long end = start + (bytes + 15) / 16 * 16;
        if (end > int.MaxValue)
            throw new InvalidOperationException($"CommandBuffer {name}: more than 2 GiB of data");
        if (end > Bytes.Length)
        {
            byte[] grown = new byte[Math.Max(end, Math.Min(int.MaxValue / 2, Bytes.Length * 2L))];
            Buffer.BlockCopy(Bytes, 0, grown, 0, start);
            Bytes = grown;
        }
        new ReadOnlySpan<byte>(data, (int)bytes).CopyTo(Bytes.AsSpan(start));
        BytesUsed = (int)end;
        return start;
    }
}
