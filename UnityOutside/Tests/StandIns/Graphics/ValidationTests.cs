using Silk.NET.Vulkan;

namespace UnityOutside.Tests.StandIns.Graphics;

public sealed unsafe class ValidationTests : GraphicsFixture
{
    /// <summary>A planted fault: what the other tests lean on is that the layer would have told.</summary>
    [Test]
    public void Validation_BufferOfZeroBytes_IsReported()
    {
        if (!HeadlessGraphics.Validate)
            Assert.Ignore("The validation layer is not installed (Debian, Ubuntu: apt-get install vulkan-validationlayers)");
        var create = new BufferCreateInfo(usage: BufferUsageFlags.TransferSrcBit);
        Silk.NET.Vulkan.Buffer handle;
        Vulkan.Api.CreateBuffer(GpuDevice.Current.Handle, &create, null, &handle);
        Assert.That(HeadlessGraphics.TakeValidationMessages(), Has.Some.Contains("VUID-VkBufferCreateInfo-size-00912"));
    }

    [Test]
    public void Check_AnError_NamesTheCall() => Assert.That(() => Vulkan.Check(Result.ErrorDeviceLost, "vkQueueSubmit2"),
        Throws.InstanceOf<InvalidOperationException>().With.Message.Contains("vkQueueSubmit2: Vulkan says ErrorDeviceLost"));
}
