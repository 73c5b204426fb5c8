Shader "Hidden/FastPoints/Compose"
{
    SubShader
    {
        Pass
        {
            Name "Compose"
            ZWrite On
            ZTest LEqual
            Cull Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FastPointsComposeVertex
            #pragma fragment FastPointsComposeFragment
            #pragma multi_compile_local _ FASTPOINTS_FROM_PIXELS FASTPOINTS_BLENDED
            #pragma multi_compile_local _ FASTPOINTS_LIT FASTPOINTS_SHADOWED
            #include "Packages/com.fastpoints.dots/Shaders/ComposePass.hlsl"
            ENDHLSL
        }
    }
}
