namespace UnityEngine;

public class Graphics
{
    static readonly CommandBuffer s_primitives = new CommandBuffer();
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

    /// <summary>Draws in every picture until the next update, where the bounds are no empty box.</summary>
    public static void RenderPrimitives(in RenderParams rparams, MeshTopology topology, int vertexCount, int instanceCount = 1)
    {
        if (rparams.Material == null)
            throw new ArgumentNullException("rparams.material");
        if (vertexCount <= 0 || instanceCount <= 0)
            throw new ArgumentOutOfRangeException(nameof(vertexCount));
        if (rparams.worldBounds.size != default)
            s_primitives.DrawProcedural(Matrix4x4.identity, rparams.Material, 0, topology, vertexCount, instanceCount,
                rparams.matProps);
    }

    internal static void ClearPrimitives() => s_primitives.Clear();

    // Opaque ones are drawn before what cameras' command buffers add after opaque meshes.
    internal static void DrawPrimitives(Camera camera, CommandBuffer before, RenderTexture cameraTarget)
    {
        if (s_primitives.Commands.Count == 0)
            return;
        before.SetViewProjectionMatrices(camera.worldToCameraMatrix, camera.projectionMatrix);
        Execute(before, s_primitives, cameraTarget);
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
