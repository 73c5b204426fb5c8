namespace StandIns.Graphics;

/// <summary>The connection to the Vulkan loader and, where asked for and there, to the validation layer.</summary>
sealed unsafe class GpuInstance
{
    const string Validation = "VK_LAYER_KHRONOS_validation";
    const string DebugUtils = "VK_EXT_debug_utils";

    // The layer calls through this for as long as the process lives.
    static readonly DebugUtilsMessengerCallbackFunctionEXT s_callback = ValidationLog.Receive;

    internal readonly Instance Handle;
    internal readonly bool IsValidated;

    internal GpuInstance(bool validate)
    {
        IsValidated = validate && LayerNames().Contains(Validation);
        using GlobalMemory layers = SilkMarshal.StringArrayToMemory(new[] { Validation });
        using GlobalMemory extensions = SilkMarshal.StringArrayToMemory(new[] { DebugUtils });
        var application = new ApplicationInfo(apiVersion: Vk.Version13);
        var messenger = new DebugUtilsMessengerCreateInfoEXT(
            messageSeverity: DebugUtilsMessageSeverityFlagsEXT.WarningBitExt | DebugUtilsMessageSeverityFlagsEXT.ErrorBitExt,
            messageType: DebugUtilsMessageTypeFlagsEXT.ValidationBitExt,
            pfnUserCallback: new PfnDebugUtilsMessengerCallbackEXT(s_callback));
        var create = new InstanceCreateInfo(pApplicationInfo: &application);
        if (IsValidated)
        {
            create.PNext = &messenger;
            create.EnabledLayerCount = 1;
            create.PpEnabledLayerNames = (byte**)(void*)layers;
            create.EnabledExtensionCount = 1;
            create.PpEnabledExtensionNames = (byte**)(void*)extensions;
        }
        Instance instance;
        Check(Api.CreateInstance(&create, null, &instance), "vkCreateInstance");
        Handle = instance;
        if (IsValidated)
            ListenTo(&messenger);
    }

    /// <summary>Devices that can do Vulkan 1.3, the fastest kind first.</summary>
    internal List<PhysicalDevice> Devices()
    {
        uint count = 0;
        Check(Api.EnumeratePhysicalDevices(Handle, &count, null), "vkEnumeratePhysicalDevices");
        var all = new PhysicalDevice[count];
        fixed (PhysicalDevice* devices = all)
            Api.EnumeratePhysicalDevices(Handle, &count, devices);
        var able = new List<PhysicalDevice>(all);
        able.RemoveAll(d => Properties(d).ApiVersion < Vk.Version13);
        able.Sort((a, b) => Rank(a).CompareTo(Rank(b)));
        return able;
    }

    internal static PhysicalDeviceProperties Properties(PhysicalDevice device) => Api.GetPhysicalDeviceProperties(device);

    static int Rank(PhysicalDevice device) => Properties(device).DeviceType switch
    {
        PhysicalDeviceType.DiscreteGpu => 0,
        PhysicalDeviceType.IntegratedGpu => 1,
        PhysicalDeviceType.VirtualGpu => 2,
        _ => 3,
    };

    static HashSet<string> LayerNames()
    {
        uint count = 0;
        Check(Api.EnumerateInstanceLayerProperties(&count, null), "vkEnumerateInstanceLayerProperties");
        var names = new HashSet<string>();
        var layers = new LayerProperties[count];
        fixed (LayerProperties* first = layers)
        {
            Api.EnumerateInstanceLayerProperties(&count, first);
            for (uint i = 0; i < count; i++)
                names.Add(SilkMarshal.PtrToString((IntPtr)first[i].LayerName));
        }
        return names;
    }

    void ListenTo(DebugUtilsMessengerCreateInfoEXT* messenger)
    {
        var create = (delegate* unmanaged[Cdecl]<Instance, DebugUtilsMessengerCreateInfoEXT*, void*,
            DebugUtilsMessengerEXT*, Result>)Api.GetInstanceProcAddr(Handle, "vkCreateDebugUtilsMessengerEXT").Handle;
        DebugUtilsMessengerEXT handle;
        Check(create(Handle, messenger, null, &handle), "vkCreateDebugUtilsMessengerEXT");
    }
}
