using System;
using System.Runtime.InteropServices;

namespace StandIns.Vulkan
{
    unsafe struct VkPhysicalDeviceFeatures
    {
        public uint robustBufferAccess;
        public uint fullDrawIndexUint32;
        public uint imageCubeArray;
        public uint independentBlend;
        public uint geometryShader;
        public uint tessellationShader;
        public uint sampleRateShading;
        public uint dualSrcBlend;
        public uint logicOp;
        public uint multiDrawIndirect;
        public uint drawIndirectFirstInstance;
        public uint depthClamp;
        public uint depthBiasClamp;
        public uint fillModeNonSolid;
        public uint depthBounds;
        public uint wideLines;
        public uint largePoints;
        public uint alphaToOne;
        public uint multiViewport;
        public uint samplerAnisotropy;
        public uint textureCompressionETC2;
        public uint textureCompressionASTC_LDR;
        public uint textureCompressionBC;
        public uint occlusionQueryPrecise;
        public uint pipelineStatisticsQuery;
        public uint vertexPipelineStoresAndAtomics;
        public uint fragmentStoresAndAtomics;
        public uint shaderTessellationAndGeometryPointSize;
        public uint shaderImageGatherExtended;
        public uint shaderStorageImageExtendedFormats;
        public uint shaderStorageImageMultisample;
        public uint shaderStorageImageReadWithoutFormat;
        public uint shaderStorageImageWriteWithoutFormat;
        public uint shaderUniformBufferArrayDynamicIndexing;
        public uint shaderSampledImageArrayDynamicIndexing;
        public uint shaderStorageBufferArrayDynamicIndexing;
        public uint shaderStorageImageArrayDynamicIndexing;
        public uint shaderClipDistance;
        public uint shaderCullDistance;
        public uint shaderFloat64;
        public uint shaderInt64;
        public uint shaderInt16;
        public uint shaderResourceResidency;
        public uint shaderResourceMinLod;
        public uint sparseBinding;
        public uint sparseResidencyBuffer;
        public uint sparseResidencyImage2D;
        public uint sparseResidencyImage3D;
        public uint sparseResidency2Samples;
        public uint sparseResidency4Samples;
        public uint sparseResidency8Samples;
        public uint sparseResidency16Samples;
        public uint sparseResidencyAliased;
        public uint variableMultisampleRate;
        public uint inheritedQueries;
    }

    unsafe struct VkPhysicalDeviceFeatures2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPhysicalDeviceFeatures features;
    }

    unsafe struct VkPhysicalDeviceVulkan12Features
    {
        public VkStructureType sType;
        public void* pNext;
        public uint samplerMirrorClampToEdge;
        public uint drawIndirectCount;
        public uint storageBuffer8BitAccess;
        public uint uniformAndStorageBuffer8BitAccess;
        public uint storagePushConstant8;
        public uint shaderBufferInt64Atomics;
        public uint shaderSharedInt64Atomics;
        public uint shaderFloat16;
        public uint shaderInt8;
        public uint descriptorIndexing;
        public uint shaderInputAttachmentArrayDynamicIndexing;
        public uint shaderUniformTexelBufferArrayDynamicIndexing;
        public uint shaderStorageTexelBufferArrayDynamicIndexing;
        public uint shaderUniformBufferArrayNonUniformIndexing;
        public uint shaderSampledImageArrayNonUniformIndexing;
        public uint shaderStorageBufferArrayNonUniformIndexing;
        public uint shaderStorageImageArrayNonUniformIndexing;
        public uint shaderInputAttachmentArrayNonUniformIndexing;
        public uint shaderUniformTexelBufferArrayNonUniformIndexing;
        public uint shaderStorageTexelBufferArrayNonUniformIndexing;
        public uint descriptorBindingUniformBufferUpdateAfterBind;
        public uint descriptorBindingSampledImageUpdateAfterBind;
        public uint descriptorBindingStorageImageUpdateAfterBind;
        public uint descriptorBindingStorageBufferUpdateAfterBind;
        public uint descriptorBindingUniformTexelBufferUpdateAfterBind;
        public uint descriptorBindingStorageTexelBufferUpdateAfterBind;
        public uint descriptorBindingUpdateUnusedWhilePending;
        public uint descriptorBindingPartiallyBound;
        public uint descriptorBindingVariableDescriptorCount;
        public uint runtimeDescriptorArray;
        public uint samplerFilterMinmax;
        public uint scalarBlockLayout;
        public uint imagelessFramebuffer;
        public uint uniformBufferStandardLayout;
        public uint shaderSubgroupExtendedTypes;
        public uint separateDepthStencilLayouts;
        public uint hostQueryReset;
        public uint timelineSemaphore;
        public uint bufferDeviceAddress;
        public uint bufferDeviceAddressCaptureReplay;
        public uint bufferDeviceAddressMultiDevice;
        public uint vulkanMemoryModel;
        public uint vulkanMemoryModelDeviceScope;
        public uint vulkanMemoryModelAvailabilityVisibilityChains;
        public uint shaderOutputViewportIndex;
        public uint shaderOutputLayer;
        public uint subgroupBroadcastDynamicId;
    }

    unsafe struct VkPhysicalDeviceVulkan13Features
    {
        public VkStructureType sType;
        public void* pNext;
        public uint robustImageAccess;
        public uint inlineUniformBlock;
        public uint descriptorBindingInlineUniformBlockUpdateAfterBind;
        public uint pipelineCreationCacheControl;
        public uint privateData;
        public uint shaderDemoteToHelperInvocation;
        public uint shaderTerminateInvocation;
        public uint subgroupSizeControl;
        public uint computeFullSubgroups;
        public uint synchronization2;
        public uint textureCompressionASTC_HDR;
        public uint shaderZeroInitializeWorkgroupMemory;
        public uint dynamicRendering;
        public uint shaderIntegerDotProduct;
        public uint maintenance4;
    }

    unsafe struct VkDeviceQueueCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint queueFamilyIndex;
        public uint queueCount;
        public float* pQueuePriorities;
    }

    unsafe struct VkDeviceCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint queueCreateInfoCount;
        public VkDeviceQueueCreateInfo* pQueueCreateInfos;
        public uint enabledLayerCount;
        public byte** ppEnabledLayerNames;
        public uint enabledExtensionCount;
        public byte** ppEnabledExtensionNames;
        public VkPhysicalDeviceFeatures* pEnabledFeatures;
    }

    static unsafe partial class Vk
    {
        [DllImport(Library)]
        internal static extern void vkGetPhysicalDeviceFeatures2(IntPtr physicalDevice,
            VkPhysicalDeviceFeatures2* pFeatures);

        [DllImport(Library)]
        internal static extern VkResult vkEnumerateDeviceExtensionProperties(IntPtr physicalDevice, byte* pLayerName,
            uint* pPropertyCount, VkExtensionProperties* pProperties);

        [DllImport(Library)]
        internal static extern VkResult vkCreateDevice(IntPtr physicalDevice, VkDeviceCreateInfo* pCreateInfo,
            void* pAllocator, IntPtr* pDevice);

        [DllImport(Library)]
        internal static extern void vkGetDeviceQueue(IntPtr device, uint queueFamilyIndex, uint queueIndex, IntPtr* pQueue);

        [DllImport(Library)]
        internal static extern IntPtr vkGetDeviceProcAddr(IntPtr device, byte* pName);

        [DllImport(Library)]
        internal static extern VkResult vkDeviceWaitIdle(IntPtr device);
    }
}
