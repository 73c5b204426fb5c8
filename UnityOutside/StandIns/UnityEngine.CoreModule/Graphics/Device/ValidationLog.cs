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

    internal static uint Receive(VkDebugUtilsMessageSeverityFlagsEXT severity, VkDebugUtilsMessageTypeFlagsEXT kind,
        VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
    {
        lock (s_messages)
            if (s_messages.Count < Kept)
                s_messages.Add(NativeStrings.Read(data->pMessage));
        return 0;
    }
}
