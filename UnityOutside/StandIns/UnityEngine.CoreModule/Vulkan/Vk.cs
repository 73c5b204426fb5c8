namespace StandIns.Vulkan;

/// <summary>The commands of Vulkan 1.3 that the stand-ins call, under their own names, so that its specification explains them. A
/// process that draws nothing never comes here, and so never loads the library. Of large structures only the fields that are read
/// or set are declared, where they lie in a 64-bit process.</summary>
static unsafe partial class Vk
{
    internal const uint ApiVersion = (1u << 22) | (3u << 12);
    internal const ulong WholeSize = ulong.MaxValue;

    const string Library = "vulkan";

#if NET
    static Vk()
    {
        NativeLibrary.SetDllImportResolver(typeof(Vk).Assembly, Resolve);
    }

    // The loader has a name of its own on each system.
    static IntPtr Resolve(string name, Assembly assembly, DllImportSearchPath? path)
    {
        if (name != Library)
            return IntPtr.Zero;
        foreach (string file in new[] { "libvulkan.so.1", "vulkan-1.dll", "libvulkan.1.dylib", "libMoltenVK.dylib" })
            if (NativeLibrary.TryLoad(file, out IntPtr loaded))
                return loaded;
        return IntPtr.Zero;
    }
#endif

    internal static void Check(VkResult result, string what)
    {
        if (result < 0)
            throw new InvalidOperationException($"{what}: Vulkan says {result}");
    }
}
