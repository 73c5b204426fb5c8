namespace UnityEngine.Rendering;

public class BaseCommandBuffer
{
    internal CommandBuffer Native;
}

public class UnsafeCommandBuffer : BaseCommandBuffer
{
    internal UnsafeCommandBuffer(CommandBuffer native) => Native = native;
}

public struct CommandBufferHelpers
{
    public static CommandBuffer GetNativeCommandBuffer(UnsafeCommandBuffer baseBuffer) => baseBuffer.Native;
}
