namespace StandIns.Graphics;

/// <summary>The connection to the Vulkan loader and, where asked for and there, to the validation layer.</summary>
sealed unsafe class GpuInstance
{
    const string Validation = "VK_LAYER_KHRONOS_validation";
    const string DebugUtils = "VK_EXT_debug_utils";

    // The layer calls through this for as long as the process lives.
    static readonly DebugCallback s_callback = ValidationLog.Receive;

    internal readonly IntPtr Handle;
    internal readonly bool IsValidated;

    delegate uint DebugCallback(VkDebugUtilsMessageSeverityFlagsEXT severity, VkDebugUtilsMessageTypeFlagsEXT kind,
        VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

    internal GpuInstance(bool validate)
    {
        IsValidated = validate && LayerNames().Contains(Validation);
        using var strings = new NativeStrings();
        var application = new VkApplicationInfo
        {
            sType = VkStructureType.ApplicationInfo,
            apiVersion = Vk.ApiVersion,
        };
        var messenger = new VkDebugUtilsMessengerCreateInfoEXT
        {
            sType = VkStructureType.DebugUtilsMessengerCreateInfoEXT,
            messageSeverity = VkDebugUtilsMessageSeverityFlagsEXT.Warning | VkDebugUtilsMessageSeverityFlagsEXT.Error,
            messageType = VkDebugUtilsMessageTypeFlagsEXT.Validation,
            pfnUserCallback = Marshal.GetFunctionPointerForDelegate(s_callback),
        };
        var create = new VkInstanceCreateInfo
        {
            sType = VkStructureType.InstanceCreateInfo,
            pApplicationInfo = &application,
        };
        if (IsValidated)
        {
            create.pNext = &messenger;
            create.enabledLayerCount = 1;
            create.ppEnabledLayerNames = strings.Array(Validation);
            create.enabledExtensionCount = 1;
            create.ppEnabledExtensionNames = strings.Array(DebugUtils);
        }
        IntPtr instance;
        Vk.Check(Vk.vkCreateInstance(&create, null, &instance), "vkCreateInstance");
        Handle = instance;
        if (IsValidated)
            ListenTo(&messenger);
    }

    /// <summary>Devices that can do Vulkan 1.3, the fastest kind first.</summary>
    internal List<IntPtr> Devices()
    {
        uint count = 0;
        Vk.Check(Vk.vkEnumeratePhysicalDevices(Handle, &count, null), "vkEnumeratePhysicalDevices");
        var all = new IntPtr[count];
        fixed (IntPtr* devices = all)
            Vk.vkEnumeratePhysicalDevices(Handle, &count, devices);
        var able = new List<IntPtr>(all);
        able.RemoveAll(d => Properties(d).apiVersion < Vk.ApiVersion);
        able.Sort((a, b) => Rank(a).CompareTo(Rank(b)));
        return able;
    }

    internal static VkPhysicalDeviceProperties Properties(IntPtr device)
    {
        VkPhysicalDeviceProperties properties;
        Vk.vkGetPhysicalDeviceProperties(device, &properties);
        return properties;
    }

    static int Rank(IntPtr device) => Properties(device).deviceType switch
    {
        VkPhysicalDeviceType.DiscreteGpu => 0,
        VkPhysicalDeviceType.IntegratedGpu => 1,
        VkPhysicalDeviceType.VirtualGpu => 2,
        _ => 3,
    };

    static HashSet<string> LayerNames()
    {
        uint count = 0;
        Vk.Check(Vk.vkEnumerateInstanceLayerProperties(&count, null), "vkEnumerateInstanceLayerProperties");
        var names = new HashSet<string>();
        var layers = new VkLayerProperties[count];
        fixed (VkLayerProperties* first = layers)
        {
            Vk.vkEnumerateInstanceLayerProperties(&count, first);
            for (uint i = 0; i < count; i++)
                names.Add(NativeStrings.Read(first[i].layerName));
        }
        return names;
    }

    void ListenTo(VkDebugUtilsMessengerCreateInfoEXT* messenger)
    {
        var create = (delegate* unmanaged[Cdecl]<IntPtr, VkDebugUtilsMessengerCreateInfoEXT*, void*, ulong*, VkResult>)
            Function("vkCreateDebugUtilsMessengerEXT");
        ulong handle;
        Vk.Check(create(Handle, messenger, null, &handle), "vkCreateDebugUtilsMessengerEXT");
    }

    IntPtr Function(string name)
    {
        fixed (byte* text = Encoding.UTF8.GetBytes(name + "\0"))
            return Vk.vkGetInstanceProcAddr(Handle, text);
    }
}
