namespace StandIns.Vulkan;

enum VkPipelineBindPoint : int { Graphics = 0, Compute = 1 }

enum VkAttachmentLoadOp : int { Load = 0 }

unsafe struct VkMemoryBarrier2
{
    public VkStructureType sType;
    public void* pNext;
    public VkPipelineStageFlags2 srcStageMask;
    public VkAccessFlags2 srcAccessMask;
    public VkPipelineStageFlags2 dstStageMask;
    public VkAccessFlags2 dstAccessMask;
}

unsafe struct VkImageMemoryBarrier2
{
    public VkStructureType sType;
    public void* pNext;
    public VkPipelineStageFlags2 srcStageMask;
    public VkAccessFlags2 srcAccessMask;
    public VkPipelineStageFlags2 dstStageMask;
    public VkAccessFlags2 dstAccessMask;
    public VkImageLayout oldLayout, newLayout;
    public uint srcQueueFamilyIndex, dstQueueFamilyIndex;
    public ulong image;
    public VkImageSubresourceRange subresourceRange;
}

unsafe struct VkDependencyInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint dependencyFlags, memoryBarrierCount;
    public VkMemoryBarrier2* pMemoryBarriers;
    public uint bufferMemoryBarrierCount;
    public void* pBufferMemoryBarriers;
    public uint imageMemoryBarrierCount;
    public VkImageMemoryBarrier2* pImageMemoryBarriers;
}

unsafe struct VkOffset2D
{
    public int x, y;
}

unsafe struct VkExtent2D
{
    public uint width, height;
}

unsafe struct VkRect2D
{
    public VkOffset2D offset;
    public VkExtent2D extent;
}

unsafe struct VkOffset3D
{
    public int x, y, z;
}

unsafe struct VkViewport
{
    public float x, y, width, height, minDepth, maxDepth;
}

[StructLayout(LayoutKind.Explicit)]
unsafe struct VkClearColorValue
{
    [FieldOffset(0)] public fixed float float32[4];
    [FieldOffset(0)] public fixed uint uint32[4];
}

unsafe struct VkClearDepthStencilValue
{
    public float depth;
    public uint stencil;
}

[StructLayout(LayoutKind.Explicit)]
unsafe struct VkClearValue
{
    [FieldOffset(0)] public VkClearColorValue color;
    [FieldOffset(0)] public VkClearDepthStencilValue depthStencil;
}

unsafe struct VkClearAttachment
{
    public VkImageAspectFlags aspectMask;
    public uint colorAttachment;
    public VkClearValue clearValue;
}

unsafe struct VkClearRect
{
    public VkRect2D rect;
    public uint baseArrayLayer, layerCount;
}

unsafe struct VkRenderingAttachmentInfo
{
    public VkStructureType sType;
    public void* pNext;
    public ulong imageView;
    public VkImageLayout imageLayout;
    public uint resolveMode;
    public ulong resolveImageView;
    public VkImageLayout resolveImageLayout;
    public VkAttachmentLoadOp loadOp;
    public uint storeOp;
    public VkClearValue clearValue;
}

unsafe struct VkRenderingInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkRect2D renderArea;
    public uint layerCount, viewMask, colorAttachmentCount;
    public VkRenderingAttachmentInfo* pColorAttachments, pDepthAttachment, pStencilAttachment;
}

unsafe struct VkBufferCopy
{
    public ulong srcOffset, dstOffset, size;
}

unsafe struct VkBufferImageCopy
{
    public ulong bufferOffset;
    public uint bufferRowLength, bufferImageHeight;
    public VkImageSubresourceLayers imageSubresource;
    public VkOffset3D imageOffset;
    public VkExtent3D imageExtent;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern void vkCmdPipelineBarrier2(IntPtr commandBuffer, VkDependencyInfo* pDependencyInfo);
    [DllImport(Library)] internal static extern void vkCmdBeginRendering(IntPtr commandBuffer, VkRenderingInfo* pRenderingInfo);
    [DllImport(Library)] internal static extern void vkCmdEndRendering(IntPtr commandBuffer);
    [DllImport(Library)]
    internal static extern void vkCmdClearAttachments(IntPtr commandBuffer, uint attachmentCount,
        VkClearAttachment* pAttachments, uint rectCount, VkClearRect* pRects);
    [DllImport(Library)]
    internal static extern void vkCmdBindPipeline(IntPtr commandBuffer, VkPipelineBindPoint pipelineBindPoint, ulong pipeline);
    [DllImport(Library)]
    internal static extern void vkCmdSetViewport(IntPtr commandBuffer, uint firstViewport, uint viewportCount,
        VkViewport* pViewports);
    [DllImport(Library)]
    internal static extern void vkCmdSetScissor(IntPtr commandBuffer, uint firstScissor, uint scissorCount, VkRect2D* pScissors);
    [DllImport(Library)]
    internal static extern void vkCmdDraw(IntPtr commandBuffer, uint vertexCount, uint instanceCount, uint firstVertex,
        uint firstInstance);
    [DllImport(Library)]
    internal static extern void vkCmdBindIndexBuffer(IntPtr commandBuffer, ulong buffer, ulong offset, uint indexType);
    [DllImport(Library)]
    internal static extern void vkCmdDrawIndexedIndirect(IntPtr commandBuffer, ulong buffer, ulong offset, uint drawCount,
        uint stride);
    [DllImport(Library)]
    internal static extern void vkCmdDrawIndirect(IntPtr commandBuffer, ulong buffer, ulong offset, uint drawCount, uint stride);
    [DllImport(Library)]
    internal static extern void vkCmdDispatch(IntPtr commandBuffer, uint groupCountX, uint groupCountY, uint groupCountZ);
    [DllImport(Library)] internal static extern void vkCmdDispatchIndirect(IntPtr commandBuffer, ulong buffer, ulong offset);
    [DllImport(Library)]
    internal static extern void vkCmdCopyBuffer(IntPtr commandBuffer, ulong srcBuffer, ulong dstBuffer,
        uint regionCount, VkBufferCopy* pRegions);
    [DllImport(Library)]
    internal static extern void vkCmdFillBuffer(IntPtr commandBuffer, ulong dstBuffer, ulong dstOffset, ulong size, uint data);
    [DllImport(Library)]
    internal static extern void vkCmdClearColorImage(IntPtr commandBuffer, ulong image, VkImageLayout imageLayout,
        VkClearColorValue* pColor, uint rangeCount, VkImageSubresourceRange* pRanges);
    [DllImport(Library)]
    internal static extern void vkCmdClearDepthStencilImage(IntPtr commandBuffer, ulong image, VkImageLayout imageLayout,
        VkClearDepthStencilValue* pDepthStencil, uint rangeCount, VkImageSubresourceRange* pRanges);
    [DllImport(Library)]
    internal static extern void vkCmdCopyImageToBuffer(IntPtr commandBuffer, ulong srcImage,
        VkImageLayout srcImageLayout, ulong dstBuffer, uint regionCount, VkBufferImageCopy* pRegions);
}
