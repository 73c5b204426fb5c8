namespace StandIns.Graphics;

sealed unsafe partial class CommandReplay
{
    readonly GpuDevice m_device;
    readonly ResourceBinder m_binder;
    readonly RenderTargets m_targets;
    readonly TemporaryTextures m_temporaries = new TemporaryTextures();
    readonly List<int> m_fences = new List<int>();
    GpuRecording m_recording;
    CommandBuffer m_buffer;
    Vector4 m_viewport;
    uint m_instanceMultiplier;

    internal CommandReplay(GpuDevice device)
    {
        m_device = device;
        m_binder = new ResourceBinder(device);
        m_targets = new RenderTargets(device);
    }

    /// <param name="before">What the engine itself does first, with the target that it leaves set; null for nothing.</param>
    /// <param name="cameraTarget">Of the camera that draws; null for none.</param>
    internal void Run(CommandBuffer buffer, CommandBuffer before = null, RenderTexture cameraTarget = null)
    {
        m_temporaries.CameraTarget = cameraTarget;
        m_targets.Reset();
        m_instanceMultiplier = 1;
        m_recording = m_device.Queue.Open();
        try
        {
            if (before != null)
                Do(before);
            Do(buffer);
            if (cameraTarget != null && m_instanceMultiplier != 1)
                throw new InvalidOperationException("the instance multiplier stays for all that the engine draws later");
        }
        finally
        {
            // What was recorded before an error is done all the same.
            m_targets.Close(m_recording);
            ulong submission = m_device.Queue.Flush();
            foreach (int fence in m_fences)
                GraphicsFence.Execute(fence, submission);
            m_fences.Clear();
        }
    }

    internal void ReleaseTemporaries() => m_temporaries.ReleaseAll();

    void Do(CommandBuffer buffer)
    {
        m_buffer = buffer;
        for (int i = 0; i < buffer.Commands.Count; i++)
            Do(buffer.Commands[i]);
    }

    void Do(in RecordedCommand command)
    {
        switch (command.Kind)
        {
            case CommandKind.SetTarget:
                SetTarget(command);
                break;
            case CommandKind.ClearTarget:
                CheckTarget("ClearRenderTarget");
                var flags = (RTClearFlags)command.A;
                m_targets.Clear(m_recording, (flags & RTClearFlags.Color) != 0, (flags & RTClearFlags.Depth) != 0,
                    m_buffer.Values[command.Data].Vector, m_buffer.Values[command.Data + 1].Vector.x);
                break;
            case CommandKind.SetViewport:
                m_viewport = m_buffer.Values[command.Data].Vector;
                break;
            case CommandKind.SetViewProjection:
                SetViewProjection(m_buffer.Values[command.Data].Matrix, m_buffer.Values[command.Data + 1].Matrix);
                break;
            case CommandKind.SetGlobal:
                PropertySheet.Global.Set(command.A, m_buffer.Values[command.Data]);
                break;
            case CommandKind.SetGlobalTexture:
                PropertySheet.Global.Set(command.A, m_temporaries.Resolve(m_buffer.Targets[command.Data]), command.B != 0);
                break;
            case CommandKind.SetKeyword:
                KeywordSet.Global.Set((string)command.X, command.A != 0);
                break;
            case CommandKind.SetConstant:
                ((ComputeShader)command.X).Constants.Set(command.A, m_buffer.Values[command.Data]);
                break;
            case CommandKind.SetKernelBuffer:
                ((ComputeShader)command.X).Kernel(command.B).Sheet.Set(command.A, (GraphicsBuffer)command.Y);
                break;
            case CommandKind.SetKernelTexture:
                ((ComputeShader)command.X).Kernel(command.B).Sheet.Set(command.A,
                    m_temporaries.Resolve(m_buffer.Targets[command.Data]), command.C != 0);
                break;
            case CommandKind.GetTemporary:
                RenderTexture temporary = m_temporaries.Get(command.A, m_buffer.Descriptors[command.Data], (FilterMode)command.B);
                PropertySheet.Global.Set(command.A, temporary);
                break;
            case CommandKind.ReleaseTemporary:
                m_temporaries.Release(command.A);
                PropertySheet.Global.Set(command.A, (Texture)null);
                break;
            case CommandKind.SetInstanceMultiplier:
                m_instanceMultiplier = (uint)command.A;
                break;
            case CommandKind.Draw:
            case CommandKind.DrawIndirect:
                Draw(command);
                break;
            case CommandKind.Dispatch:
            case CommandKind.DispatchIndirect:
                Dispatch(command);
                break;
            default:
                Transfer(command);
                break;
        }
    }

    void Transfer(in RecordedCommand command)
    {
        m_targets.Close(m_recording);
        switch (command.Kind)
        {
            case CommandKind.Upload:
                fixed (byte* bytes = m_buffer.Bytes)
                    ((GraphicsBuffer)command.X).Record(m_recording, bytes + command.Data, command.A, command.B, command.C);
                break;
            case CommandKind.CopyBuffer:
                GpuBuffer source = ((GraphicsBuffer)command.X).ForDevice();
                m_recording.Barrier();
                m_recording.Copy(source, 0, ((GraphicsBuffer)command.Y).ForDevice(), 0, source.Bytes);
                break;
            case CommandKind.Fence:
                m_fences.Add(command.A);
                break;
            case CommandKind.ReadBuffer:
                ReadbackTable.Add((GraphicsBuffer)command.X, command.B, command.A, (Action<AsyncGPUReadbackRequest>)command.Y);
                break;
            case CommandKind.ReadTexture:
                ReadbackTable.Add((Texture)command.X, (Action<AsyncGPUReadbackRequest>)command.Y);
                break;
        }
    }

    void SetTarget(in RecordedCommand command)
    {
        m_targets.Close(m_recording);
        m_targets.Begin(command.B);
        for (int i = 0; i <= command.A; i++)
        {
            Texture texture = m_temporaries.Resolve(m_buffer.Targets[command.Data + i]);
            if (texture is null)
                continue;
            var target = texture as RenderTexture
                ?? throw new InvalidOperationException($"{texture.name} cannot be drawn into: it is no render texture");
            target.ImageFor(isDepth: false);
            if (i < command.A && target.Color != null)
                m_targets.AddColor(target.Color);
            else if (i == command.A && target.Depth != null)
                m_targets.SetDepth(target.Depth);
        }
        m_viewport = m_targets.IsSet ? m_targets.Complete() : default;
        // Rows of textures begin at the picture's lowest, those of screens at its topmost.
        bool isScreen = m_targets.IsSet &&
            m_temporaries.Resolve(m_buffer.Targets[command.Data]) is RenderTexture { IsScreen: true };
        PropertySheet.Global.Set(s_projectionParams, PropertyValue.Of(new Vector4(isScreen ? 1 : -1, 0, 0, 0)));
    }

    void CheckTarget(string what)
    {
        if (!m_targets.IsSet)
            throw new InvalidOperationException($"{what} in command buffer {m_buffer.name}: no render target is set");
    }

    void Dispatch(in RecordedCommand command)
    {
        m_targets.Close(m_recording);
        var shader = (ComputeShader)command.X;
        ComputeKernel kernel = shader.Kernel(command.A);
        ComputeProgram program = kernel.Program(shader.Keywords);
        var scope = new PropertyScope(kernel.Sheet, shader.Constants);
        m_recording.Barrier();
        Api.CmdBindPipeline(m_recording.Commands, PipelineBindPoint.Compute, program.Pipeline);
        m_binder.Bind(m_recording, PipelineBindPoint.Compute, program.Name, program.Layout, scope);
        if (command.Kind == CommandKind.Dispatch)
        {
            Api.CmdDispatch(m_recording.Commands, (uint)command.B, (uint)command.C, (uint)command.D);
            return;
        }
        const int bytes = 12;
        GpuBuffer arguments = Arguments((GraphicsBuffer)command.Y, command.B, bytes);
        Api.CmdDispatchIndirect(m_recording.Commands, arguments.Handle, (uint)command.B);
    }

    GpuBuffer Arguments(GraphicsBuffer buffer, int offset, int bytes)
    {
        if ((buffer.target & GraphicsBuffer.Target.IndirectArguments) == 0)
            throw new InvalidOperationException($"{buffer.Label} was not made with Target.IndirectArguments");
        if (offset < 0 || offset % 4 != 0 || offset + bytes > buffer.Bytes)
            throw new InvalidOperationException($"{buffer.Label}: no arguments at byte {offset} of {buffer.Bytes}");
        GpuBuffer memory = buffer.ForDevice();
        memory.LastUse = m_recording.Number;
        return memory;
    }
}
