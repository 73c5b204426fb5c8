namespace UnityEngine;

public class Graphics
{
    static CommandReplay s_replay;

    /// <summary>Sends the commands to the device, and does not wait for them.</summary>
    /// <exception cref="InvalidOperationException">A command names what is not there: the message says which.</exception>
    public static void ExecuteCommandBuffer(CommandBuffer buffer) => Execute(null, buffer);

    internal static void Execute(CommandBuffer before, CommandBuffer buffer, RenderTexture cameraTarget = null)
    {
        if (buffer == null)
            throw new ArgumentNullException(nameof(buffer));
        buffer.CheckReleased();
        s_replay ??= new CommandReplay(GpuDevice.Current);
        s_replay.Run(buffer, before, cameraTarget);
        if (cameraTarget == null)
            s_replay.ReleaseTemporaries();
    }

    /// <summary>What a camera's command buffers have not released goes with its picture.</summary>
    internal static void EndCamera() => s_replay?.ReleaseTemporaries();

    /// <summary>Has passed when the device has done all that was asked of it until now.</summary>
    public static GraphicsFence CreateGraphicsFence(GraphicsFenceType fenceType, SynchronisationStageFlags stage)
    {
        GraphicsFence fence = GraphicsFence.Create(fenceType);
        GraphicsFence.Execute(fence.Id, Math.Max(1, GpuDevice.Current.Queue.Flush()));
        return fence;
    }
}
