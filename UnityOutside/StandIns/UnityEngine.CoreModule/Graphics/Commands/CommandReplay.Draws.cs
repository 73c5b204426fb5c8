namespace StandIns.Graphics;

sealed unsafe partial class CommandReplay
{
    static readonly int s_view = PropertyNames.IdOf("unity_MatrixV");
    static readonly int s_projection = PropertyNames.IdOf("glstate_matrix_projection");
    static readonly int s_projectionParams = PropertyNames.IdOf("_ProjectionParams");
    static readonly int s_viewProjection = PropertyNames.IdOf("unity_MatrixVP");
    static readonly int s_objectToWorld = PropertyNames.IdOf("unity_ObjectToWorld");
    static readonly int s_worldToObject = PropertyNames.IdOf("unity_WorldToObject");

    static void SetViewProjection(in Matrix4x4 view, in Matrix4x4 projection)
    {
        Matrix4x4 forDevice = GL.GetGPUProjectionMatrix(projection, renderIntoTexture: true);
        PropertySheet.Global.Set(s_view, PropertyValue.Of(view));
        PropertySheet.Global.Set(s_projection, PropertyValue.Of(forDevice));
        PropertySheet.Global.Set(s_viewProjection, PropertyValue.Of(forDevice * view));
    }

    void Draw(in RecordedCommand command)
    {
        CheckTarget("A draw");
        var material = (Material)command.X;
        if (material == null)
            throw new InvalidOperationException($"A draw in command buffer {m_buffer.name}: its material was destroyed");
        ShaderPass pass = material.shader.Source.Pass(command.A);
        Matrix4x4 matrix = m_buffer.Values[command.Data].Matrix;
        PropertySheet.Global.Set(s_objectToWorld, PropertyValue.Of(matrix));
        PropertySheet.Global.Set(s_worldToObject, PropertyValue.Of(matrix.inverse));

        GraphicsProgram program = pass.Program(material.Keywords);
        var scope = new PropertyScope((PropertySheet)command.Y, material.Sheet, pass.Shader.Defaults);
        Pipeline pipeline =
            program.Pipeline(new PipelineKey(m_targets, pass.State.Evaluate(scope), TopologyOf((MeshTopology)command.B)));
        int argumentBytes = command.Indices != null ? GraphicsBuffer.IndirectDrawIndexedArgs.size
            : GraphicsBuffer.IndirectDrawArgs.size;
        GpuBuffer arguments = command.Kind == CommandKind.DrawIndirect
            ? Arguments((GraphicsBuffer)command.Z, command.C, argumentBytes) : null;
        ResourceBinder.MakeTextures(m_recording, m_targets, program.Layout, scope);
        m_targets.Open(m_recording);
        m_targets.SetViewport(m_recording, m_viewport);
        Api.CmdBindPipeline(m_recording.Commands, PipelineBindPoint.Graphics, pipeline);
        m_binder.Bind(m_recording, PipelineBindPoint.Graphics, program.Name, program.Layout, scope);
        if (command.Indices != null)
            DrawIndexed(command.Indices, arguments, command.C);
        else if (arguments != null)
            Api.CmdDrawIndirect(m_recording.Commands, arguments.Handle, (ulong)command.C, 1, 0);
        else
            Api.CmdDraw(m_recording.Commands, (uint)command.C, (uint)command.D * m_instanceMultiplier, 0, 0);
    }

    void DrawIndexed(GraphicsBuffer indices, GpuBuffer arguments, int offset)
    {
        if ((indices.target & GraphicsBuffer.Target.Index) == 0)
            throw new InvalidOperationException($"{indices.Label} was not made with Target.Index");
        GpuBuffer memory = indices.ForDevice();
        memory.LastUse = m_recording.Number;
        IndexType type = indices.stride == 2 ? IndexType.Uint16 : IndexType.Uint32;
        Api.CmdBindIndexBuffer(m_recording.Commands, memory.Handle, 0, type);
        Api.CmdDrawIndexedIndirect(m_recording.Commands, arguments.Handle, (ulong)offset, 1, 0);
    }

    static PrimitiveTopology TopologyOf(MeshTopology topology) => topology switch
    {
        MeshTopology.Triangles => PrimitiveTopology.TriangleList,
        MeshTopology.Lines => PrimitiveTopology.LineList,
        MeshTopology.LineStrip => PrimitiveTopology.LineStrip,
        MeshTopology.Points => PrimitiveTopology.PointList,
        _ => throw new NotSupportedException($"MeshTopology.{topology}: not every API has it"),
    };
}
