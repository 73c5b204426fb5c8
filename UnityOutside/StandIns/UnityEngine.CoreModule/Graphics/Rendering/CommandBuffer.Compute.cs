namespace UnityEngine.Rendering;

// X is the shader; A the name, B the kernel of what is set; A the kernel of a dispatch.
public partial class CommandBuffer
{
    public void SetComputeIntParam(ComputeShader computeShader, int nameID, int val) =>
        SetConstant(computeShader, nameID, PropertyValue.Of(val));

    public void SetComputeVectorParam(ComputeShader computeShader, int nameID, Vector4 val) =>
        SetConstant(computeShader, nameID, PropertyValue.Of(val));

    public void SetComputeMatrixParam(ComputeShader computeShader, int nameID, Matrix4x4 val) =>
        SetConstant(computeShader, nameID, PropertyValue.Of(val));

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBuffer buffer) =>
        Add(new RecordedCommand
        {
            Kind = CommandKind.SetKernelBuffer,
            X = computeShader,
            Y = buffer,
            A = nameID,
            B = kernelIndex
        });

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt) =>
        SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, 0);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt,
        int mipLevel) =>
        SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, mipLevel, RenderTextureSubElement.Default);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt,
        int mipLevel, RenderTextureSubElement element) => Add(new RecordedCommand
        {
            Kind = CommandKind.SetKernelTexture,
            X = computeShader,
            A = nameID,
            B = kernelIndex,
            C = element == RenderTextureSubElement.Depth ? 1 : 0,
            Data = AddTarget(rt),
        });

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY,
        int threadGroupsZ)
    {
        const int most = 65535;
        if (threadGroupsX < 1 || threadGroupsY < 1 || threadGroupsZ < 1
            || Math.Max(threadGroupsX, Math.Max(threadGroupsY, threadGroupsZ)) > most)
            throw new ArgumentException($"{computeShader.name}: {threadGroupsX} x {threadGroupsY} x {threadGroupsZ} groups; "
                + $"from 1 to {most} "
                + "are possible");
        Add(new RecordedCommand
        {
            Kind = CommandKind.Dispatch,
            X = computeShader,
            A = kernelIndex,
            B = threadGroupsX,
            C = threadGroupsY,
            D = threadGroupsZ,
        });
    }

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, GraphicsBuffer indirectBuffer, uint argsOffset) =>
        Add(new RecordedCommand
        {
            Kind = CommandKind.DispatchIndirect,
            X = computeShader,
            Y = indirectBuffer,
            A = kernelIndex,
            B = (int)argsOffset,
        });

    void SetConstant(ComputeShader shader, int nameID, in PropertyValue value) =>
        Add(new RecordedCommand { Kind = CommandKind.SetConstant, X = shader, A = nameID, Data = AddValue(value) });
}
