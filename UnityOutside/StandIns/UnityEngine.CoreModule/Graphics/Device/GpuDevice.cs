namespace StandIns.Graphics;

sealed unsafe class GpuDevice
{
    const string PushDescriptor = "VK_KHR_push_descriptor";

    static readonly object s_lock = new object();
    static GpuDevice s_current;
    static string s_reason;

    internal readonly IntPtr Handle;
    internal readonly IntPtr Physical;
    internal readonly string Name;
    internal readonly VkPhysicalDeviceLimits Limits;
    internal readonly GpuMemory Memory;
    internal readonly GpuQueue Queue;
    internal readonly bool IsValidated;
    /// <summary>A storage image may be written whose format the shader does not name.</summary>
    internal readonly bool WritesAnyFormat;
    internal readonly delegate* unmanaged[Cdecl]<IntPtr, VkPipelineBindPoint, ulong, uint, uint, VkWriteDescriptorSet*, void>
        PushDescriptors;

    GpuDevice(bool validate)
    {
        var instance = new GpuInstance(validate);
        IsValidated = instance.IsValidated;
        foreach (IntPtr device in instance.Devices())
            if (Physical == IntPtr.Zero && HasExtension(device, PushDescriptor) && UniversalFamily(device) >= 0)
                Physical = device;
        if (Physical == IntPtr.Zero)
            throw new InvalidOperationException("no device with Vulkan 1.3 and " + PushDescriptor);
        VkPhysicalDeviceProperties properties = GpuInstance.Properties(Physical);
        Name = NativeStrings.Read(properties.deviceName);
        Limits = properties.limits;
        uint family = (uint)UniversalFamily(Physical);
        Handle = Create(family, out WritesAnyFormat);
        IntPtr queue;
        Vk.vkGetDeviceQueue(Handle, family, 0, &queue);
        fixed (byte* name = Encoding.UTF8.GetBytes("vkCmdPushDescriptorSetKHR\0"))
            PushDescriptors =
                (delegate* unmanaged[Cdecl]<IntPtr, VkPipelineBindPoint, ulong, uint, uint, VkWriteDescriptorSet*, void>)
                Vk.vkGetDeviceProcAddr(Handle, name);
        Memory = new GpuMemory(this);
        Queue = new GpuQueue(this, queue, family);
        // A driver that draws with threads of this process must be done with it before the process ends.
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Vk.vkDeviceWaitIdle(Handle);
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
                catch (DllNotFoundException)
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

    internal unsafe bool CanBlend(VkFormat format)
    {
        const uint colorAttachmentBlend = 0x100;
        VkFormatProperties properties;
        Vk.vkGetPhysicalDeviceFormatProperties(Physical, format, &properties);
        return (properties.optimalTilingFeatures & colorAttachmentBlend) != 0;
    }

    internal bool ChoosesSlices { get; private set; }

    IntPtr Create(uint family, out bool writesAnyFormat)
    {
        var able13 = new VkPhysicalDeviceVulkan13Features { sType = VkStructureType.PhysicalDeviceVulkan13Features };
        var able12 = new VkPhysicalDeviceVulkan12Features
        {
            sType = VkStructureType.PhysicalDeviceVulkan12Features,
            pNext = &able13,
        };
        var able = new VkPhysicalDeviceFeatures2 { sType = VkStructureType.PhysicalDeviceFeatures2, pNext = &able12 };
        Vk.vkGetPhysicalDeviceFeatures2(Physical, &able);
        if (able13.dynamicRendering == 0 || able13.synchronization2 == 0 || able12.timelineSemaphore == 0)
            throw new InvalidOperationException(Name + " lacks dynamic rendering, synchronization2 or timeline semaphores");
        writesAnyFormat = able.features.shaderStorageImageWriteWithoutFormat != 0;

        var want13 = new VkPhysicalDeviceVulkan13Features
        {
            sType = VkStructureType.PhysicalDeviceVulkan13Features,
            dynamicRendering = 1,
            synchronization2 = 1,
        };
        var want12 = new VkPhysicalDeviceVulkan12Features
        {
            sType = VkStructureType.PhysicalDeviceVulkan12Features,
            pNext = &want13,
            timelineSemaphore = 1,
            scalarBlockLayout = able12.scalarBlockLayout,
            shaderOutputLayer = able12.shaderOutputLayer,
            shaderOutputViewportIndex = able12.shaderOutputViewportIndex,
        };
        // Reads past the end of a buffer give zero, as with Direct3D.
        var want = new VkPhysicalDeviceFeatures2 { sType = VkStructureType.PhysicalDeviceFeatures2, pNext = &want12 };
        want.features.robustBufferAccess = able.features.robustBufferAccess;
        want.features.drawIndirectFirstInstance = able.features.drawIndirectFirstInstance;
        want.features.vertexPipelineStoresAndAtomics = able.features.vertexPipelineStoresAndAtomics;
        want.features.fragmentStoresAndAtomics = able.features.fragmentStoresAndAtomics;
        want.features.shaderStorageImageWriteWithoutFormat = able.features.shaderStorageImageWriteWithoutFormat;
        // For a vertex shader that chooses the slice, glslang asks for this as well.
        want.features.geometryShader = able.features.geometryShader;
        want.features.independentBlend = able.features.independentBlend;
        want.features.shaderInt64 = able.features.shaderInt64;

        using var strings = new NativeStrings();
        var extensions = new List<string> { PushDescriptor };
        ChoosesSlices = HasExtension(Physical, "VK_EXT_shader_viewport_index_layer");
        if (ChoosesSlices)
            extensions.Add("VK_EXT_shader_viewport_index_layer");
        ChoosesSlices |= able12.shaderOutputLayer != 0;
        float priority = 1;
        var queue = new VkDeviceQueueCreateInfo
        {
            sType = VkStructureType.DeviceQueueCreateInfo,
            queueFamilyIndex = family,
            queueCount = 1,
            pQueuePriorities = &priority,
        };
        var create = new VkDeviceCreateInfo
        {
            sType = VkStructureType.DeviceCreateInfo,
            pNext = &want,
            queueCreateInfoCount = 1,
            pQueueCreateInfos = &queue,
            enabledExtensionCount = (uint)extensions.Count,
            ppEnabledExtensionNames = strings.Array(extensions.ToArray()),
        };
        IntPtr device;
        Vk.Check(Vk.vkCreateDevice(Physical, &create, null, &device), "vkCreateDevice");
        return device;
    }

    static bool HasExtension(IntPtr device, string name)
    {
        uint count = 0;
        Vk.vkEnumerateDeviceExtensionProperties(device, null, &count, null);
        var extensions = new VkExtensionProperties[count];
        fixed (VkExtensionProperties* first = extensions)
        {
            Vk.vkEnumerateDeviceExtensionProperties(device, null, &count, first);
            for (uint i = 0; i < count; i++)
                if (NativeStrings.Read(first[i].extensionName) == name)
                    return true;
        }
        return false;
    }

    // A queue that draws and computes can copy as well.
    static int UniversalFamily(IntPtr device)
    {
        uint count = 0;
        Vk.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, null);
        var families = new VkQueueFamilyProperties[count];
        fixed (VkQueueFamilyProperties* first = families)
            Vk.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, first);
        const VkQueueFlags all = VkQueueFlags.Graphics | VkQueueFlags.Compute;
        return Array.FindIndex(families, f => (f.queueFlags & all) == all);
    }
}
