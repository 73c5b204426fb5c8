namespace StandIns.Graphics;

static unsafe class ValidationLog
{
    const int Kept = 200;
    static readonly List<string> s_messages = new List<string>();

    /// <summary>The messages since the last call.</summary>
    internal static string[] Take()
    {
        lock (s_messages)
        {
            string[] taken = s_messages.ToArray();
            s_messages.Clear();
            return taken;
        }
    }

    internal static uint Receive(DebugUtilsMessageSeverityFlagsEXT severity, DebugUtilsMessageTypeFlagsEXT kind,
        DebugUtilsMessengerCallbackDataEXT* data, void* user)
    {
        lock (s_messages)
            if (s_messages.Count < Kept)
                s_messages.Add(SilkMarshal.PtrToString((IntPtr)data->PMessage));
        return 0;
    }
}
