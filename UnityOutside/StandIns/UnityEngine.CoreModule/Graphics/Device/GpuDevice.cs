namespace StandIns.Graphics;

sealed unsafe class GpuDevice
{
    const string PushDescriptor = "VK_KHR_push_descriptor";

    static readonly object s_lock = new object();
    static GpuDevice s_current;
    static string s_reason;

    internal readonly Device Handle;
    internal readonly PhysicalDevice Physical;
    internal readonly string Name;
    internal readonly PhysicalDeviceLimits Limits;
    internal readonly GpuMemory Memory;
    internal readonly GpuQueue Queue;
    internal readonly bool IsValidated;
    internal readonly bool WritesAnyFormat; // A storage image may be written whose format the shader does not name.
    internal readonly delegate* unmanaged[Cdecl]<VkCommandBuffer, PipelineBindPoint, PipelineLayout, uint, uint,
        WriteDescriptorSet*, void> PushDescriptors;

    GpuDevice(bool validate)
    {
        var instance = new GpuInstance(validate);
        IsValidated = instance.IsValidated;
        foreach (PhysicalDevice device in instance.Devices())
            if (Physical.Handle == 0 && Api.IsDeviceExtensionPresent(device, PushDescriptor) && UniversalFamily(device) >= 0)
                Physical = device;
        if (Physical.Handle == 0)
            throw new InvalidOperationException("no device with Vulkan 1.3 and " + PushDescriptor);
        PhysicalDeviceProperties properties = GpuInstance.Properties(Physical);
        Name = SilkMarshal.PtrToString((IntPtr)properties.DeviceName);
        Limits = properties.Limits;
        uint family = (uint)UniversalFamily(Physical);
        Handle = Create(family, out WritesAnyFormat);
        Queue queue;
        Api.GetDeviceQueue(Handle, family, 0, &queue);
        PushDescriptors = (delegate* unmanaged[Cdecl]<VkCommandBuffer, PipelineBindPoint, PipelineLayout, uint, uint,
            WriteDescriptorSet*, void>)Api.GetDeviceProcAddr(Handle, "vkCmdPushDescriptorSetKHR").Handle;
        Memory = new GpuMemory(this);
        Queue = new GpuQueue(this, queue, family);
        // A driver that draws with threads of this process must be done with it before the process ends.
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Api.DeviceWaitIdle(Handle);
    }

    internal static bool Validate { get; set; }
    internal static bool Exists => s_current != null;

    internal static GpuDevice Current =>
        s_current ?? TryGet(out string reason) ?? throw new InvalidOperationException("No graphics device: " + reason);

    /// <summary>The device, or null and the reason.</summary>
    internal static GpuDevice TryGet(out string reason)
    {
        lock (s_lock)
        {
            if (s_current == null && s_reason == null)
                try
                {
                    s_current = new GpuDevice(Validate);
                }
                catch (TypeInitializationException e) when (e.InnerException is FileNotFoundException)
                {
                    s_reason = "there is no Vulkan loader (Debian, Ubuntu: apt-get install libvulkan1 mesa-vulkan-drivers)";
                }
                catch (InvalidOperationException e)
                {
                    s_reason = e.Message + " (Debian, Ubuntu: apt-get install mesa-vulkan-drivers)";
                }
            reason = s_reason;
            return s_current;
        }
    }

    internal bool CanBlend(Format format)
    {
        FormatFeatureFlags able = Api.GetPhysicalDeviceFormatProperties(Physical, format).OptimalTilingFeatures;
        return (able & FormatFeatureFlags.ColorAttachmentBlendBit) != 0;
    }

    internal bool ChoosesSlices { get; private set; }

    Device Create(uint family, out bool writesAnyFormat)
    {
        var able13 = new PhysicalDeviceVulkan13Features(pNext: null);
        var able12 = new PhysicalDeviceVulkan12Features(pNext: &able13);
        var able = new PhysicalDeviceFeatures2(pNext: &able12);
        Api.GetPhysicalDeviceFeatures2(Physical, &able);
        if (!able13.DynamicRendering || !able13.Synchronization2 || !able12.TimelineSemaphore)
            throw new InvalidOperationException(Name + " lacks dynamic rendering, synchronization2 or timeline semaphores");
        writesAnyFormat = able.Features.ShaderStorageImageWriteWithoutFormat;

        var want13 = new PhysicalDeviceVulkan13Features(dynamicRendering: 1, synchronization2: 1);
        var want12 = new PhysicalDeviceVulkan12Features(pNext: &want13, timelineSemaphore: 1,
            scalarBlockLayout: able12.ScalarBlockLayout, shaderOutputLayer: able12.ShaderOutputLayer,
            shaderOutputViewportIndex: able12.ShaderOutputViewportIndex);
        // Reads past the end of a buffer give zero, as with Direct3D.
        var want = new PhysicalDeviceFeatures2(pNext: &want12);
        want.Features.RobustBufferAccess = able.Features.RobustBufferAccess;
        want.Features.DrawIndirectFirstInstance = able.Features.DrawIndirectFirstInstance;
        want.Features.VertexPipelineStoresAndAtomics = able.Features.VertexPipelineStoresAndAtomics;
        want.Features.FragmentStoresAndAtomics = able.Features.FragmentStoresAndAtomics;
        want.Features.ShaderStorageImageWriteWithoutFormat = able.Features.ShaderStorageImageWriteWithoutFormat;
        // For a vertex shader that chooses the slice, glslang asks for this as well.
        want.Features.GeometryShader = able.Features.GeometryShader;
        want.Features.IndependentBlend = able.Features.IndependentBlend;
        want.Features.ShaderInt64 = able.Features.ShaderInt64;

        var extensions = new List<string> { PushDescriptor };
        ChoosesSlices = Api.IsDeviceExtensionPresent(Physical, "VK_EXT_shader_viewport_index_layer");
        if (ChoosesSlices)
            extensions.Add("VK_EXT_shader_viewport_index_layer");
        ChoosesSlices |= able12.ShaderOutputLayer;
        using GlobalMemory names = SilkMarshal.StringArrayToMemory(extensions);
        float priority = 1;
        var queue = new DeviceQueueCreateInfo(queueFamilyIndex: family, queueCount: 1, pQueuePriorities: &priority);
        var create = new DeviceCreateInfo(pNext: &want, queueCreateInfoCount: 1, pQueueCreateInfos: &queue,
            enabledExtensionCount: (uint)extensions.Count, ppEnabledExtensionNames: (byte**)(void*)names);
        Device device;
        Check(Api.CreateDevice(Physical, &create, null, &device), "vkCreateDevice");
        return device;
    }

    // A queue that draws and computes can copy as well.
    static int UniversalFamily(PhysicalDevice device)
    {
        uint count = 0;
        Api.GetPhysicalDeviceQueueFamilyProperties(device, &count, null);
        var families = new QueueFamilyProperties[count];
        fixed (QueueFamilyProperties* first = families)
            Api.GetPhysicalDeviceQueueFamilyProperties(device, &count, first);
        const QueueFlags all = QueueFlags.GraphicsBit | QueueFlags.ComputeBit;
        return Array.FindIndex(families, f => (f.QueueFlags & all) == all);
    }
}
